// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_BASE_READ_FILE_H_
#define JPRIM_SRC_BASE_READ_FILE_H_

#include <optional>
#include <string>
#include <string_view>

#include "jprim/base/diagnostic.h"

namespace jprim {

/// The bytes of a file, but for the mark that some editors put before UTF-8; nothing if it cannot be read.
std::optional<std::string> readFile(const std::string& path);

/// What a message says of a file that cannot be read.
constexpr const char* UnreadableFile = "cannot read the file; check its name and permissions";

/// The folder of a file, from which relative names in it start.
std::string getFolder(const std::string& path);

/// What `read` makes of the text of a file, with the file's folder. An error, and an empty result, if it cannot be read.
template <class Result>
Result readFrom(const std::string& path, Diagnostics& diagnostics,
                Result (*read)(std::string_view, Diagnostics&)) {
    const std::optional<std::string> text = readFile(path);
    if (!text) {
        diagnostics.push_back({Severity::Error, {}, UnreadableFile});
        return {};
    }
    Result result = read(*text, diagnostics);
    result.folder = getFolder(path);
    return result;
}

}  // namespace jprim

#endif
