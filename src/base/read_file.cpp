// SPDX-License-Identifier: Apache-2.0
#include "base/read_file.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

namespace jprim {

std::optional<std::string> readFile(const std::string& path) {
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    std::error_code code;  // a folder has no size, although it can be opened
    const std::uintmax_t size = std::filesystem::file_size(path, code);
    std::ifstream file(path, std::ios::binary);
    if (code || !file) return std::nullopt;
    std::string text(static_cast<std::size_t>(size), '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (!file) return std::nullopt;
    if (text.compare(0, byteOrderMark.size(), byteOrderMark) == 0) text.erase(0, byteOrderMark.size());
    return text;
}

std::string getFolder(const std::string& path) {
    return std::filesystem::path(path).parent_path().string();
}

}  // namespace jprim
