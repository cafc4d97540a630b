// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_TESTS_TOOL_TOOL_FIXTURE_H_
#define JPRIM_TESTS_TOOL_TOOL_FIXTURE_H_

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace jprim::testing {

namespace fs = std::filesystem;

struct Outcome {
    int exitCode = -1;
    std::string out;
    std::string err;
};

inline std::string readFile(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Runs the command in a folder of its own.
class Tool : public ::testing::Test {
protected:
    Tool() : m_folder(fs::temp_directory_path() / ("jprim_tool_test_" + std::to_string(getpid()))) {
        fs::create_directories(m_folder);
    }
    ~Tool() override { fs::remove_all(m_folder); }

    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(m_folder / name) << text;
        return (m_folder / name).string();
    }

    // Runs `jprim arguments…` with both outputs in files.
    Outcome run(const std::string& arguments) const {
        Outcome result;
        const std::string out = (m_folder / "out").string(), err = (m_folder / "err").string();
        const int status =
            std::system((std::string(JPRIM_TOOL) + " " + arguments + " >" + out + " 2>" + err).c_str());
        result.exitCode = WEXITSTATUS(status);
        result.out = readFile(out);
        result.err = readFile(err);
        return result;
    }

    // The same on a terminal; what the terminal shows.
    static std::string runOnTerminal(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), JPRIM_TOOL);
        std::vector<char*> argv;
        for (std::string& argument : arguments) argv.push_back(argument.data());
        argv.push_back(nullptr);
        int terminal = -1;
        const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
        if (child == 0) {
            execv(argv[0], argv.data());
            _exit(127);
        }
        std::string shown;
        char buffer[4096];
        for (ssize_t n = 0; (n = read(terminal, buffer, sizeof buffer)) > 0;) shown.append(buffer, size_t(n));
        close(terminal);
        waitpid(child, nullptr, 0);
        return shown;
    }

    fs::path m_folder;
};

}  // namespace jprim::testing

#endif
