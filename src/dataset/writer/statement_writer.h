// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_WRITER_STATEMENT_WRITER_H_
#define JPRIM_SRC_DATASET_WRITER_STATEMENT_WRITER_H_

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "jprim/dataset/dataset.h"

namespace jprim {

/// Puts statements on lines of bearable length. Arguments are added one by one; one that is empty or has no
/// value writes nothing.
class StatementWriter {
public:
    explicit StatementWriter(std::string& text) : m_text(text) {}

    /// `KEYWORD/id`, or `KEYWORD/` for id 0.
    void begin(std::string_view keyword, int id);
    /// An argument as it stands, if it is not empty.
    void add(std::string_view argument);
    /// An expression may be broken only at its spaces, where the comma of the next line changes nothing.
    void addExpression(std::string_view name, std::string_view expression);
    void end();

    void add(std::string_view name, const std::optional<double>& number);
    void add(std::string_view name, int id);
    void add(std::string_view name, const std::string& text);
    void add(std::string_view name, const std::optional<Triple>& triple);
    void add(std::string_view name, const std::optional<ExpressionText>& expression);
    void add(std::string_view name, const std::vector<int>& ids);
    void add(std::string_view name, const std::vector<double>& numbers);
    void add(std::string_view name, const std::vector<std::string>& names);

    /// The same for every type that a member may have; of a bool only the name.
    template <class T>
    void addValue(std::string_view name, const T& value) {
        if constexpr (std::is_same_v<T, bool>)
            add(name);
        else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, Triple> ||
                           std::is_same_v<T, ExpressionText>)
            add(name, std::optional<T>(value));
        else
            add(name, value);
    }

private:
    static constexpr std::size_t LongestLine = 78;  // leaves room for a closing backslash

    void breakLine();

    std::string& m_text;
    std::string m_line;
    bool m_first = false;
    bool m_backslash = false;
};

}  // namespace jprim

#endif
