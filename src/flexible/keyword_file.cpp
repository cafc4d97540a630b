// SPDX-License-Identifier: Apache-2.0
#include "flexible/keyword_file.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/format.h"
#include "base/text.h"
#include "jprim/base/error.h"

namespace jprim {
namespace {

const char* const Remedy = "check its name and permissions";

bool isComment(std::string_view line) {
    return line.empty() || line.substr(0, 2) == "**";
}

std::string_view stripQuotes(std::string_view text) {
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') return text.substr(1, text.size() - 2);
    return text;
}

// The fields between commas, none after the last comma if nothing follows it.
std::vector<std::string_view> split(std::string_view line) {
    std::vector<std::string_view> fields;
    while (!line.empty()) {
        const std::size_t comma = std::min(line.find(','), line.size());
        fields.push_back(stripQuotes(trim(line.substr(0, comma))));
        line.remove_prefix(std::min(comma + 1, line.size()));
    }
    return fields;
}

// Of a keyword line that ends with a comma: whether the next line has more parameters rather than data.
bool hasParameters(std::string_view line) {
    return !line.empty() && line.front() != '*' && line.find('=') != line.npos;
}

}  // namespace

KeywordFile::KeywordFile(const std::string& path) {
    m_files.emplace_back(path, Remedy);
}

bool KeywordFile::nextLine() {
    while (true) {
        if (!m_files.back().nextLine()) {
            if (m_files.size() == 1) return false;
            m_files.pop_back();
            continue;
        }
        const std::string_view line = trim(m_files.back().getLine());
        if (isComment(line)) continue;
        m_isKeyword = line.front() == '*';
        if (!m_isKeyword) {
            m_isContinued = line.back() == ',';
            m_fields = split(line);
            return true;
        }
        if (readKeywordLine(line)) return true;
    }
}

// False for *INCLUDE, whose lines may be data of the block it stands in.
bool KeywordFile::readKeywordLine(std::string_view line) {
    std::vector<std::string_view> fields = split(line.substr(1));
    while (line.back() == ',' && hasParameters(trim(m_files.back().getLineAhead()))) {
        m_files.back().nextLine();
        line = trim(m_files.back().getLine());
        for (const std::string_view field : split(line)) fields.push_back(field);
    }
    Parameters parameters;
    for (const std::string_view field : fields) {
        const std::size_t equals = std::min(field.find('='), field.size());
        const std::string_view value = field.substr(std::min(equals + 1, field.size()));
        parameters[toUpperCase(trim(field.substr(0, equals)))] = stripQuotes(trim(value));
    }
    const std::string keyword = fields.empty() ? "" : toUpperCase(fields.front());
    if (keyword == "INCLUDE") {
        openInclude(parameters["INPUT"]);
        return false;
    }
    m_keyword = keyword;
    m_parameters = std::move(parameters);
    return true;
}

void KeywordFile::openInclude(const std::string& name) {
    constexpr std::size_t deepest = 20;
    if (name.empty()) fail("*INCLUDE needs INPUT=file");
    if (m_files.size() > deepest) fail("*INCLUDE goes too deep; a file must not include itself");
    const std::filesystem::path folder = std::filesystem::path(m_files.back().getPath()).parent_path();
    try {
        m_files.emplace_back((folder / name).string(), Remedy);
    } catch (const Error& error) {
        fail(std::string("*INCLUDE: ") + error.what());
    }
}

std::string KeywordFile::getParameter(const std::string& name) const {
    const auto found = m_parameters.find(name);
    return found == m_parameters.end() ? "" : found->second;
}

int KeywordFile::readId(std::string_view field, const char* what) const {
    int id = 0;
    std::string_view rest = field;
    if (!takeNumber(rest, id) || !rest.empty() || id < 0)
        fail(fmt::format("{} is not {}", quote(field), what));
    return id;
}

double KeywordFile::readReal(std::string_view field) const {
    double value = 0;
    std::string_view rest = field;
    if (!field.empty() && (!takeNumber(rest, value) || !rest.empty()))
        fail(fmt::format("{} is not a number", quote(field)));
    return value;
}

void KeywordFile::fail(const std::string& message) const {
    m_files.back().fail(message);
}

}  // namespace jprim
