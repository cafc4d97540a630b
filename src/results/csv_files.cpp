// SPDX-License-Identifier: Apache-2.0
#include "jprim/results/csv_files.h"

#include <filesystem>

#include "base/format.h"
#include "jprim/base/error.h"

namespace jprim {

namespace {

std::string makeField(const std::string& name) {
    if (name.find_first_of(",\"\r\n") == name.npos) return name;
    std::string field = "\"";
    for (const char c : name) field += c == '"' ? "\"\"" : std::string(1, c);
    return field + "\"";
}

std::string makeHeader(const std::vector<std::string>& columns) {
    std::vector<std::string> fields;
    fields.reserve(columns.size());
    for (const std::string& name : columns) fields.push_back(makeField(name));
    return join(fields, ",");
}

}  // namespace

CsvFiles::File CsvFiles::open(const std::string& folder, const char* name) {
    const std::filesystem::path path = std::filesystem::path(folder) / name;
    File file{path.string(), std::ofstream(path, std::ios::binary)};
    if (!file.stream) throw Error(file.path, "cannot be written");
    return file;
}

CsvFiles::CsvFiles(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw Error(folder, "cannot be made: " + error.message());
    m_files = {open(folder, "requests.csv"), open(folder, "reactions.csv"), open(folder, "parts.csv")};
}

void CsvFiles::write(File& file, const std::string& line) {
    file.stream << line << '\n' << std::flush;
    if (!file.stream) throw Error(file.path, "cannot be written");
}

void CsvFiles::begin(const ResultColumns& columns) {
    write(m_files.requests, makeHeader(columns.requests));
    write(m_files.reactions, makeHeader(columns.reactions));
    write(m_files.parts, makeHeader(columns.parts));
}

void CsvFiles::add(const ResultRow& row) {
    write(m_files.requests, join(row.requests, ","));
    write(m_files.reactions, join(row.reactions, ","));
    write(m_files.parts, join(row.parts, ","));
}

}  // namespace jprim
