// SPDX-License-Identifier: Apache-2.0
#include "jprim/simulation/results.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "base/format.h"
#include "jprim/base/error.h"

namespace jprim {

std::vector<double> Table::getColumn(const std::string& name) const {
    const auto found = std::find(columns.begin(), columns.end(), name);
    if (found == columns.end()) throw Error(name, "is not a column of the results");
    std::vector<double> column;
    for (size_t k = size_t(found - columns.begin()); k < values.size(); k += columns.size())
        column.push_back(values[k]);
    return column;
}

namespace {

// A field of a file of comma separated values, as RFC 4180 has it.
std::string makeField(const std::string& name) {
    if (name.find_first_of(",\"\r\n") == name.npos) return name;
    std::string field = "\"";
    for (const char c : name) field += c == '"' ? "\"\"" : std::string(1, c);
    return field + "\"";
}

void writeTable(const Table& table, const std::filesystem::path& path) {
    std::string text;
    std::vector<std::string> header;
    for (const std::string& name : table.columns) header.push_back(makeField(name));
    appendText(text, "{}\n", join(header, ","));
    for (size_t row = 0; row < table.getNumRows(); ++row) {
        const double* const values = table.values.data() + row * table.columns.size();
        for (size_t k = 0; k < table.columns.size(); ++k) appendText(text, "{}{}", k > 0 ? "," : "", values[k]);
        text += '\n';
    }
    std::ofstream file(path, std::ios::binary);
    file.write(text.data(), std::streamsize(text.size()));
    file.close();
    if (!file) throw Error(path.string(), "cannot be written");
}

}  // namespace

void writeResults(const Results& results, const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw Error(folder, "cannot be made: " + error.message());
    const std::filesystem::path directory(folder);
    writeTable(results.requests, directory / "requests.csv");
    writeTable(results.reactions, directory / "reactions.csv");
    writeTable(results.parts, directory / "parts.csv");
}

}  // namespace jprim
