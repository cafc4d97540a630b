// SPDX-License-Identifier: Apache-2.0
// Feeds arbitrary bytes to the reader of commands. A crash, a sanitizer's finding or a broken property stops it.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "dataset/command_properties.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const std::string broken = jprim::findBrokenCommandProperty(text);
    if (broken.empty()) return 0;
    std::fprintf(stderr, "%s\n", broken.c_str());
    std::abort();
}
