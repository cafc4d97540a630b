// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_DATASET_READ_DATASET_H_
#define JPRIM_DATASET_READ_DATASET_H_

#include <string>
#include <string_view>

#include "jprim/base/diagnostic.h"
#include "jprim/dataset/dataset.h"

namespace jprim {

/// Reads the text of an Adams/Solver dataset.
///
/// Never throws on account of the text and never stops at the first mistake: each statement ends as
/// built, ignored by a declared rule, or an error in `diagnostics`; the three add up to the statements
/// in the text (Dataset::counts). Ids are checked too: every id given twice in a kind, and every
/// reference to a statement that does not exist, is an error at the reference. Time and memory are linear
/// in the length of the text.
///
/// @param      text         the whole file; lines end in LF or CRLF
/// @param[out] diagnostics  findings are appended in the order of the file
/// @returns what could be read; use it only if there is no error among the diagnostics
Dataset readDataset(std::string_view text, Diagnostics& diagnostics);

/// Reads a dataset from a file and notes the file's folder in it. A file that cannot be read is one error
/// without position.
Dataset readDatasetFile(const std::string& path, Diagnostics& diagnostics);

}  // namespace jprim

#endif
