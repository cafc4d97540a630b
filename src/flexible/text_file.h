// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_FLEXIBLE_TEXT_FILE_H_
#define JPRIM_SRC_FLEXIBLE_TEXT_FILE_H_

#include <cstddef>
#include <string>
#include <string_view>

namespace jprim {

/// A text file in memory, handed out line by line.
class TextFile {
public:
    /// @param path    as messages show it
    /// @param remedy  ends the message about a missing or empty file
    /// @throws Error for what cannot be read, is empty or is no text
    TextFile(std::string path, const std::string& remedy);

    /// Moves to the next line; false at the end.
    bool nextLine();

    /// The line without its end, which is LF or CR LF.
    std::string_view getLine() const;

    /// The line that nextLine() would move to; empty at the end.
    std::string_view getLineAhead() const;

    const std::string& getPath() const { return m_path; }
    std::size_t getSize() const { return m_text.size(); }

    /// The line as messages name it: `path:line`.
    std::string getWhere() const;

    /// Refuses the line with `path:line: message`.
    [[noreturn]] void fail(const std::string& message) const;

private:
    std::string_view getLineAt(std::size_t begin) const;

    std::string m_path, m_text;
    std::size_t m_begin = 0, m_next = 0;  // this line, the line ahead
    int m_lineNumber = 0;
};

/// Takes a number that ends at a blank, and the blanks before it, off the front of the text. False if the
/// text begins with something else.
bool takeNumber(std::string_view& text, int& value);

/// The same for a real: `5`, `-.5`, `2.07E+005`, or with the D that Fortran writes, `2.07D+005`.
bool takeNumber(std::string_view& text, double& value);

}  // namespace jprim

#endif
