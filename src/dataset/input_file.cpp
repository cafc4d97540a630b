// SPDX-License-Identifier: Apache-2.0
#include "dataset/input_file.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace jprim {

InputFile::InputFile(const std::string& path, Diagnostics& diagnostics) {
    std::error_code code;  // a folder has no size, although it can be opened
    const std::uintmax_t size = std::filesystem::file_size(path, code);
    std::ifstream file(path, std::ios::binary);
    if (!code) {
        text.resize(static_cast<std::size_t>(size));
        file.read(text.data(), static_cast<std::streamsize>(text.size()));
    }
    good = !code && file;
    folder = std::filesystem::path(path).parent_path().string();
    if (!good)
        diagnostics.push_back({Severity::Error, {}, "cannot read the file; check its name and permissions"});
}

}  // namespace jprim
