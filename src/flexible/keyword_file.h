// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_FLEXIBLE_KEYWORD_FILE_H_
#define JPRIM_SRC_FLEXIBLE_KEYWORD_FILE_H_

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "flexible/text_file.h"

namespace jprim {

/// An Abaqus or CalculiX input file: keyword lines such as `*NODE, NSET=ALL`, each with data lines below it.
/// Comments and empty lines are left out, and *INCLUDE stands for the lines of the file it names.
class KeywordFile {
public:
    /// @throws Error if the file cannot be read
    explicit KeywordFile(const std::string& path);

    /// Moves to the next keyword or data line; false at the end of the file.
    bool nextLine();

    /// True on a keyword line, false on a data line.
    bool isKeyword() const { return m_isKeyword; }

    /// The keyword of this line or of the data line's block, in upper case without its star.
    const std::string& getKeyword() const { return m_keyword; }

    bool hasParameter(const std::string& name) const { return m_parameters.count(name) > 0; }

    /// The keyword's parameter as written, without quotes; empty if it is absent or has no value.
    std::string getParameter(const std::string& name) const;

    /// The comma-separated fields of the data line without blanks around them. A comma that ends the line
    /// adds no field.
    const std::vector<std::string_view>& getFields() const { return m_fields; }

    /// A field as a number that is not negative. @throws Error that says the field is not `what`
    int readId(std::string_view field, const char* what) const;

    /// A field as a real; an empty one is a zero. @throws Error
    double readReal(std::string_view field) const;

    /// True if the data line ends with a comma.
    bool isContinued() const { return m_isContinued; }

    /// The line as messages name it: `path:line`.
    std::string getWhere() const { return m_files.back().getWhere(); }

    /// Refuses the line with `path:line: message`.
    [[noreturn]] void fail(const std::string& message) const;

private:
    using Parameters = std::map<std::string, std::string>;

    bool readKeywordLine(std::string_view line);
    void openInclude(const std::string& name);

    std::vector<TextFile> m_files;  // each includes the next
    bool m_isKeyword = false, m_isContinued = false;
    std::string m_keyword;
    Parameters m_parameters;
    std::vector<std::string_view> m_fields;
};

}  // namespace jprim

#endif
