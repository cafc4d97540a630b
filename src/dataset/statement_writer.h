// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_STATEMENT_WRITER_H_
#define JPRIM_SRC_DATASET_STATEMENT_WRITER_H_

#include <optional>
#include <string>
#include <string_view>
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
    /// An argument as it stands.
    void add(std::string_view argument);
    /// An expression may be broken only at its spaces, where the comma of the next line changes nothing.
    void addExpression(std::string_view name, std::string_view expression);
    void end();

    void add(std::string_view name, const std::optional<double>& number);
    void add(std::string_view name, int id);
    void add(std::string_view name, const std::string& text);
    void add(std::string_view name, const std::optional<Triple>& triple);
    void add(std::string_view name, const std::optional<ExpressionText>& expression);
    void add(std::string_view name, const std::vector<double>& numbers);
    void add(std::string_view name, const std::vector<std::string>& names);

private:
    static constexpr std::size_t LongestLine = 78;  // leaves room for a closing backslash

    void breakLine();

    std::string& m_text;
    std::string m_line;
    bool m_first = false;
    bool m_backslash = false;
};

// One function for each kind of statement that connects, moves or measures; bodies are in write_dataset.cpp.
void write(StatementWriter& w, const JprimStatement& s);
void write(StatementWriter& w, const JointStatement& s);
void write(StatementWriter& w, const GconStatement& s);
void write(StatementWriter& w, const MotionStatement& s);
void write(StatementWriter& w, const CouplerStatement& s);
void write(StatementWriter& w, const SforceStatement& s);
void write(StatementWriter& w, const VectorForceStatement& s);
void write(StatementWriter& w, const SpringdamperStatement& s);
void write(StatementWriter& w, const BushingStatement& s);
void write(StatementWriter& w, const VariableStatement& s);
void write(StatementWriter& w, const SplineStatement& s);
void write(StatementWriter& w, const SensorStatement& s);

}  // namespace jprim

#endif
