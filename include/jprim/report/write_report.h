// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_REPORT_WRITE_REPORT_H_
#define JPRIM_REPORT_WRITE_REPORT_H_

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jprim/base/diagnostic.h"
#include "jprim/dataset/dataset.h"
#include "jprim/mechanism/mechanism.h"
#include "jprim/results/results.h"

namespace jprim {

/// What a report says in words. Nothing here is needed.
struct ReportNotes {
    std::string file;         ///< the dataset's name
    std::string datasetText;  ///< as it stands in the file; as writeDataset() writes it if empty
    std::vector<std::pair<std::string, std::string>> options;  ///< of the run: {"--end", "2"}
    std::vector<std::string> summary;                          ///< lines: how the run went
    std::vector<std::string> analysis;                         ///< lines: freedoms, redundant equations
    std::vector<std::pair<std::string, Diagnostic>>
        warnings;  ///< and errors, with the file that each is about
    std::optional<int> freedoms;
};

/// False if the library was built without node and npm: then there is no page to put results into.
bool canWriteReports();

/// Writes one HTML file that shows a mechanism moving, with all results as curves, and needs nothing else: it opens
/// from disk in any browser.
/// @param results  of simulating this mechanism
/// @throws Error if the results are of another mechanism, the file cannot be written, or not canWriteReports()
void writeReport(const Dataset& dataset, const Mechanism& mechanism, const Results& results,
                 const std::string& path, const ReportNotes& notes = {});

}  // namespace jprim

#endif
