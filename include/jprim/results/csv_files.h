// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_RESULTS_CSV_FILES_H_
#define JPRIM_RESULTS_CSV_FILES_H_

#include <fstream>
#include <string>

#include "jprim/results/result_sink.h"

namespace jprim {

/// requests.csv, reactions.csv and parts.csv in a folder, which is made if need be. Fields are separated by commas, as
/// RFC 4180 has it; numbers carry the digits that reproduce them exactly. Each row is written when it is added, so that
/// a program that is killed leaves all rows up to then.
class CsvFiles final : public ResultSink {
public:
    /// Empties the files. @throws Error if one cannot be written
    explicit CsvFiles(const std::string& folder);

    void begin(const ResultColumns& columns) override;
    /// @throws Error if the row cannot be written
    void add(const ResultRow& row) override;

private:
    struct File {
        std::string path;
        std::ofstream stream;
    };

    static File open(const std::string& folder, const char* name);
    static void write(File& file, const std::string& line);

    TypedResultTables<File> m_files;
};

}  // namespace jprim

#endif
