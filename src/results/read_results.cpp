// SPDX-License-Identifier: Apache-2.0
#include "jprim/results/read_results.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "base/format.h"
#include "base/read_file.h"
#include "jprim/base/error.h"

namespace jprim {

namespace {

class CsvReader {
public:
    explicit CsvReader(const std::filesystem::path& path) : m_path(path.string()) {
        const std::optional<std::string> text = readFile(m_path);
        if (!text) throw Error(m_path, UnreadableFile);
        m_text = *text;
    }

    Table read() {
        Table table;
        if (!readHeader(table.columns)) throw Error(m_path, "has no header");
        while (m_at < m_text.size() && m_text.find('\n', m_at) != m_text.npos) readRow(table);
        return table;
    }

private:
    // RFC 4180: a field may be in quotes, in which a quote stands twice.
    bool readHeader(std::vector<std::string>& columns) {
        for (bool isQuoted = false; m_at < m_text.size();) {
            if (columns.empty()) columns.emplace_back();
            const char c = m_text[m_at++];
            if (c == '"') {
                const bool isDouble = isQuoted && m_at < m_text.size() && m_text[m_at] == '"';
                if (isDouble) columns.back() += m_text[m_at++];
                isQuoted = isDouble || !isQuoted;
            } else if (c == ',' && !isQuoted) {
                columns.emplace_back();
            } else if (c == '\n' && !isQuoted) {
                return true;
            } else {
                columns.back() += c;
            }
        }
        return false;
    }

    void readRow(Table& table) {
        ++m_row;
        for (size_t k = 0; k < table.columns.size(); ++k) {
            const char* const begin = m_text.c_str() + m_at;
            char* end = nullptr;
            table.values.push_back(std::strtod(begin, &end));
            const char expected = k + 1 < table.columns.size() ? ',' : '\n';
            if (end == begin || *end != expected)
                throw Error(m_path, fmt::format("row {} of numbers cannot be understood at column {}", m_row,
                                                table.columns[k]));
            m_at += size_t(end - begin) + 1;
        }
    }

    std::string m_path, m_text;
    size_t m_at = 0, m_row = 0;
};

}  // namespace

Results readResults(const std::string& folder) {
    const auto read = [&folder](const char* name) {
        return CsvReader(std::filesystem::path(folder) / name).read();
    };
    Results results{read("requests.csv"), read("reactions.csv"), read("parts.csv")};
    Table* const tables[] = {&results.requests, &results.reactions, &results.parts};
    size_t rows = results.parts.getNumRows();
    for (const Table* table : tables) rows = std::min(rows, table->getNumRows());
    for (Table* table : tables) table->values.resize(rows * table->columns.size());
    return results;
}

}  // namespace jprim
