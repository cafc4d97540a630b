// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_LANGUAGE_STATEMENT_READER_H_
#define JPRIM_SRC_DATASET_LANGUAGE_STATEMENT_READER_H_

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/language/arguments.h"
#include "dataset/language/read_state.h"
#include "dataset/language/statement_lexer.h"

namespace jprim {

/// One statement being read: its name for messages, its errors, and its arguments by table.
class StatementReader {
public:
    StatementReader(ReadState& state, const StatementText& statement);

    /// What was understood so far.
    std::string_view getKeyword() const { return m_keyword; }  ///< in full
    int getId() const { return m_id; }
    std::string getName() const;         ///< "MARKER/3"; "UNITS"
    SourcePosition getPosition() const;  ///< of the keyword
    ReadState& updState() { return m_state; }

    /// Adds an error or warning about what stands at this offset of the statement's text.
    void addError(std::size_t offset, std::string message);
    void addWarning(std::size_t offset, std::string message);
    bool hasErrors() const { return m_errors > 0; }

    /// Reads the word before the slash, and the slash.
    std::string_view readKeyword();
    /// Reads what follows the slash up to the first argument. False if the statement cannot be read further.
    bool readHead(std::string_view fullKeyword, bool hasId);
    /// Adds this statement to those of its kind; a second one with the same id is an error. Nothing is done
    /// if the id was unreadable. Owner and floating are those of a MARKER.
    void registerId(const Owner& owner = {}, bool floating = false);

    /// Reads all arguments into the statement. False if there was any error; if not, every argument that the
    /// fields require was given.
    template <class Fields, class S>
    bool readArguments(const Fields& fields, S& statement) {
        ArgumentValue value;
        m_rules = &fields.getRules();
        while (readArgument(value)) {
            if (value.row < m_rules->size()) fields.read(statement, value);
        }
        return checkMandatory();
    }
    /// Reads a whole statement that has an id: where it stands, the id, the arguments. False if there was any
    /// error.
    template <class Fields, class S>
    bool readStatement(const Fields& fields, S& statement) {
        statement.where = getPosition();
        statement.id = m_id;
        readArguments(fields, statement);
        registerId();
        return !hasErrors();
    }
    /// A second statement of a kind that stands once is an error.
    template <class S>
    bool checkOnce(const std::optional<S>& earlier) {
        if (earlier) addSecond(earlier->where.line);
        return !earlier;
    }
    /// The arguments as text, blanks and line breaks made uniform.
    std::string readRawArguments();

    /// Lets the markers that this statement names belong to any body.
    void allowAnyOwner();
    /// Notes that the argument with this name uses coordinates of the joints it names: of each the one given, or the only
    /// one if none are given. The remedy is how to say which.
    void useJoints(std::string_view name, const std::vector<CouplerType>& coordinates, const char* remedy);

    /// Where the argument with this full name begins; the keyword if it was not given.
    std::size_t getOffset(std::string_view name) const;
    /// Where what is given for it begins; only of one that was given.
    std::size_t getValueOffset(std::string_view name) const { return findGiven(name)->valueOffset; }
    /// True if a number given for it has the suffix D.
    bool isInDegrees(std::string_view name) const { return has(name) && findGiven(name)->degrees; }
    bool has(std::string_view name) const { return findGiven(name) != nullptr; }
    bool has(ArgumentKind kind) const;
    /// The word that comes next; empty if none does.
    std::string_view peekWord() const { return peekName(m_at).word; }

    /// Of two arguments that say the same thing only one may be given.
    void checkNotBoth(const char* name, const char* other);
    /// An argument that is given must be one that the statement's type has; `owners` says which types have it.
    void checkAllowed(const char* name, bool allowed, const char* owners);
    /// An argument that the statement's type needs must be given.
    void checkNeeded(const char* name, bool needed);

private:
    struct Name {
        std::string_view word;
        bool atEnd = false;   // nothing follows but blanks
        char first = 0;       // else the first character, even if it is none of a word
        bool equals = false;  // the word is followed by '='
    };
    // An argument that was given, and where.
    struct Given {
        const ArgumentRule* rule;
        std::size_t offset;
        std::size_t valueOffset = 0;
        bool degrees = false;
    };

    Name peekName(std::size_t offset) const;
    const Given* findGiven(std::string_view name) const;
    void addSecond(int line);

    // One argument, good or bad; false after the last. A bad one leaves a row beyond the table.
    bool readArgument(ArgumentValue& value);
    bool beginArgument();
    const ArgumentRule* readArgumentName(std::size_t& offset);
    bool checkGiven(const ArgumentRule& rule, std::size_t offset);
    bool readEquals(const ArgumentRule& rule, std::size_t offset);
    bool readValue(const ArgumentRule& rule, ArgumentValue& value);
    bool readNumbers(const ArgumentRule& rule, ArgumentValue& value);
    bool readNumber(const ArgumentRule& rule, ArgumentValue& value);
    bool isNextValue(const ArgumentRule& rule, std::size_t count) const;
    bool readWords(const ArgumentRule& rule, ArgumentValue& value);
    bool readNames(const ArgumentRule& rule, ArgumentValue& value);
    bool readListedName(const ArgumentRule& rule, ArgumentValue& value);
    bool isNextName() const;
    bool checkNotUser(const ArgumentRule& rule);
    bool readExpression(const ArgumentRule& rule, ArgumentValue& value);
    void endExpression(std::size_t end);
    void skipArgument();
    bool checkMandatory();
    void addReferences(const ArgumentRule& rule, const ArgumentValue& value);

    std::string_view readWord();
    std::string_view takeItem();
    void skipBlanks();
    bool atEnd() const { return m_at >= m_text.size(); }
    std::string describe(const ArgumentRule& rule) const;

    // A statement that went this wrong is not worth more messages; it also bounds their number in a file
    // of nothing but commas.
    static constexpr int MostErrors = 10;

    ReadState& m_state;
    const StatementText& m_statement;
    std::string_view m_text;
    std::size_t m_number;  // of this statement in the file
    std::string_view m_keyword;
    int m_id = 0;
    std::size_t m_at = 0;
    bool m_comma = false;     // the last thing read was a comma, so an argument must follow
    bool m_hasValue = false;  // the last name was followed by '='
    int m_errors = 0;
    const std::vector<ArgumentRule>* m_rules = nullptr;
    std::vector<Given> m_given;
};

}  // namespace jprim

#endif
