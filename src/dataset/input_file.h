// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_INPUT_FILE_H_
#define JPRIM_SRC_DATASET_INPUT_FILE_H_

#include <string>

#include "jprim/base/diagnostic.h"

namespace jprim {

/// A file's text and folder. One that cannot be read is an error without position, and `good` is false.
struct InputFile {
    InputFile(const std::string& path, Diagnostics& diagnostics);

    bool good = false;
    std::string text;
    std::string folder;
};

}  // namespace jprim

#endif
