// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_SUPPORT_MESH_FOLDER_H_
#define JPRIM_TESTS_SUPPORT_MESH_FOLDER_H_

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace jprim::testing {

/// An empty folder for the files of the running test.
class MeshFolder {
public:
    MeshFolder() {
        const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
        std::string name = std::string("jprim_") + test->test_suite_name() + "_" + test->name();
        for (char& c : name)
            if (c == '/') c = '_';
        m_folder = std::filesystem::path(::testing::TempDir()) / name;
        std::filesystem::remove_all(m_folder);
        std::filesystem::create_directories(m_folder);
    }
    ~MeshFolder() { std::filesystem::remove_all(m_folder); }
    MeshFolder(const MeshFolder&) = delete;
    MeshFolder& operator=(const MeshFolder&) = delete;

    std::string getPath(const std::string& name) const { return (m_folder / name).string(); }

    /// Writes a file and returns its path.
    std::string write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((m_folder / name).parent_path());
        std::ofstream(m_folder / name, std::ios::binary) << text;
        return getPath(name);
    }

    std::string read(const std::string& name) const {
        std::ostringstream text;
        text << std::ifstream(m_folder / name, std::ios::binary).rdbuf();
        return text.str();
    }

    /// Copies the files NAME.* that CalculiX read and wrote.
    void copyMesh(const std::string& name) const {
        for (const char* ending : {".inp", ".dof", ".sti", ".mas"})
            std::filesystem::copy_file(std::string(JPRIM_SOURCE_DIR) + "/tests/data/mesh/" + name + ending,
                                       m_folder / (name + ending));
    }

    /// The message without the folder's path.
    std::string shorten(std::string message) const {
        const std::string prefix = getPath("");
        for (std::size_t at; (at = message.find(prefix)) != std::string::npos;)
            message.erase(at, prefix.size());
        return message;
    }

private:
    std::filesystem::path m_folder;
};

}  // namespace jprim::testing

#endif
