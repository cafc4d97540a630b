// SPDX-License-Identifier: Apache-2.0
#include "flexible/text_file.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "base/format.h"
#include "base/read_file.h"
#include "base/text.h"
#include "jprim/base/error.h"

namespace jprim {
namespace {

std::string readText(const std::string& path, const std::string& remedy) {
    std::optional<std::string> text = readFile(path);
    if (!text) throw Error(path, "cannot read the file; " + remedy);
    if (text->empty()) throw Error(path, "the file is empty; " + remedy);
    if (text->find('\0') != text->npos) throw Error(path, "the file is no plain text; " + remedy);
    return *std::move(text);
}

// Takes the word up to the next blank off the front of the text. Numbers may carry a plus sign, of which
// from_chars knows nothing.
std::string_view takeWord(std::string_view& text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    const auto end = std::find_if(text.begin(), text.end(), isBlank);
    std::string_view word = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(word.size());
    if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
    return word;
}

// From_chars knows "inf" and "nan", which are no numbers here.
bool beginsNumber(std::string_view word) {
    if (!word.empty() && word.front() == '-') word.remove_prefix(1);
    return !word.empty() && (word.front() == '.' || isDigit(word.front()));
}

template <class T>
std::from_chars_result readWord(std::string_view word, T& value) {
    return std::from_chars(word.data(), word.data() + word.size(), value);
}

}  // namespace

TextFile::TextFile(std::string path, const std::string& remedy)
    : m_path(std::move(path)), m_text(readText(m_path, remedy)) {}

bool TextFile::nextLine() {
    if (m_next >= m_text.size()) return false;
    m_begin = m_next;
    m_next = std::min(m_text.find('\n', m_begin), m_text.size() - 1) + 1;
    ++m_lineNumber;
    return true;
}

std::string_view TextFile::getLine() const {
    return getLineAt(m_begin);
}

std::string_view TextFile::getLineAhead() const {
    return getLineAt(m_next);
}

std::string_view TextFile::getLineAt(std::size_t begin) const {
    std::string_view line = std::string_view(m_text).substr(begin);
    line = line.substr(0, line.find('\n'));
    return !line.empty() && line.back() == '\r' ? line.substr(0, line.size() - 1) : line;
}

std::string TextFile::getWhere() const {
    return fmt::format("{}:{}", m_path, m_lineNumber);
}

void TextFile::fail(const std::string& message) const {
    throw Error(getWhere(), message);
}

bool takeNumber(std::string_view& text, int& value) {
    const std::string_view word = takeWord(text);
    const auto [stop, code] = readWord(word, value);
    return code == std::errc() && stop == word.data() + word.size();
}

bool takeNumber(std::string_view& text, double& value) {
    const std::string_view word = takeWord(text);
    if (!beginsNumber(word)) return false;
    const auto [stop, code] = readWord(word, value);
    if (code != std::errc()) return false;
    if (stop == word.data() + word.size()) return true;
    if (*stop != 'D' && *stop != 'd') return false;
    std::string withE(word);
    withE[static_cast<std::size_t>(stop - word.data())] = 'E';
    const auto [stopE, codeE] = readWord(withE, value);
    return codeE == std::errc() && stopE == withE.data() + withE.size();
}

}  // namespace jprim
