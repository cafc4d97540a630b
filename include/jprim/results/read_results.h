// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_RESULTS_READ_RESULTS_H_
#define JPRIM_RESULTS_READ_RESULTS_H_

#include <string>

#include "jprim/results/results.h"

namespace jprim {

/// Reads what CsvFiles wrote into a folder. A last line that was cut off is left out, and with it what the other files
/// have of that time.
/// @throws Error, naming file and line, if a file cannot be read or understood
Results readResults(const std::string& folder);

}  // namespace jprim

#endif
