// SPDX-License-Identifier: Apache-2.0
// FLEX_BODY: a body that bends.
#include <algorithm>

#include "base/format.h"
#include "base/numbers.h"
#include "base/text.h"
#include "dataset/body_arguments.h"
#include "dataset/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using V = ArgumentValue;

// The statement, and beside it what is understood only when all is read.
struct FlexBodyArguments : FlexBodyStatement {
    ArgumentValue file;
    ArgumentValue ratio;
    ArgumentValue invariants;
    std::optional<std::size_t> adamsRow;  // of the first argument that brings modes in a format of Adams
};
using F = FlexBodyArguments;
using Row = ArgumentTable<F>::Row;

// checkModes() refuses these, once for all of them.
Row makeAdamsRow(std::string_view name, std::size_t minimum) {
    return {{name, Kind::Ignored, minimum}, [](F& f, const V& v) {
                if (!f.adamsRow) f.adamsRow = v.row;
            }};
}

const ArgumentTable<F>& getFlexBodyTable() {
    static const ArgumentTable<F> table =
        makeBodyTable<F>({{{"MODES_FILE", Kind::Text, 3}, [](F& f, const V& v) { f.file = v; }},
                          {{"CRATIO", Kind::Expression, 2}, [](F& f, const V& v) { f.ratio = v; }},
                          {{"INVARIANTS", Kind::Text, 3}, [](F& f, const V& v) { f.invariants = v; }},
                          {{"CHAR_LEN", Kind::Ignored, 2}, nullptr},
                          {{"DMODE", Kind::Unsupported, 2}, nullptr},
                          makeAdamsRow("MNF_FILE", 2),
                          makeAdamsRow("DB_FILE", 2),
                          makeAdamsRow("BDF_FILE", 2),
                          makeAdamsRow("GENSTIFF", 2),
                          makeAdamsRow("INVAR1", ExactOnly),
                          makeAdamsRow("INVAR2", ExactOnly),
                          makeAdamsRow("INVAR3", ExactOnly),
                          makeAdamsRow("INVAR4", ExactOnly),
                          makeAdamsRow("INVAR5", ExactOnly),
                          makeAdamsRow("INVAR6", ExactOnly),
                          makeAdamsRow("INVAR7", ExactOnly),
                          makeAdamsRow("INVAR8", ExactOnly),
                          makeAdamsRow("INVAR9", ExactOnly),
                          makeAdamsRow("T_MODE", 2),
                          makeAdamsRow("R_MODE", 2),
                          makeAdamsRow("SELNOD", 4),
                          makeAdamsRow("SELMOD", 4)});
    return table;
}

void checkModes(StatementReader& reader, const F& arguments, bool good) {
    if (arguments.adamsRow) {
        const std::string_view name = getFlexBodyTable().getRules()[*arguments.adamsRow].name;
        reader.addError(reader.getOffset(name),
                        fmt::format("{} of {}: modes in a format of Adams cannot be read, because it is "
                                    "closed; let 'jprim reduce' make a file of modes from a finite-element "
                                    "mesh and name it: MODES_FILE=",
                                    name, reader.getName()));
    } else if (good && !reader.has("MODES_FILE")) {
        reader.addError(0, fmt::format("{} needs MODES_FILE: MODES_FILE=", reader.getName()));
    }
}

// A file name as given; one in quotes may have blanks, and quotes of the other kind.
void understandFile(StatementReader& reader, F& arguments) {
    if (!reader.has("MODES_FILE")) return;
    std::string_view name = arguments.file.text;
    std::string_view forbidden = " \t\r\v\f\"'";
    if (name.size() > 1 && name.front() == name.back() && (name.front() == '"' || name.front() == '\'')) {
        forbidden = name.front() == '"' ? "\"" : "'";
        name = name.substr(1, name.size() - 2);
    }
    if (name.empty() || name.find_first_of(forbidden) != name.npos)
        reader.addError(arguments.file.offset,
                        fmt::format("MODES_FILE of {}: {} is not a file name; one with blanks stands in "
                                    "quotes, one with a comma, semicolon, & or ! in double ones",
                                    reader.getName(), quote(arguments.file.text)));
    arguments.modesFile = std::string(name);
}

void understandRatio(StatementReader& reader, F& arguments) {
    const V& given = arguments.ratio;
    if (given.expression.text.empty()) return;  // not given, or already reported
    const Number<double> ratio = parseReal(given.expression.text, false);
    arguments.cratio = ratio.value;
    if (!ratio.fault.empty())
        reader.addError(given.offset, fmt::format("CRATIO of {}: {}; only a number is supported here",
                                                  reader.getName(), ratio.fault));
    else if (ratio.value < 0)
        reader.addError(given.offset, fmt::format("CRATIO of {} is {}; damping cannot be negative",
                                                  reader.getName(), ratio.value));
}

// "true : F" as "TF"; a word that is neither becomes '?'.
std::string shortenPattern(std::string_view pattern) {
    static const std::vector<Word> words = {{"TRUE"}, {"FALSE"}};
    std::string letters;
    for (bool more = true; more;) {
        const std::size_t colon = std::min(pattern.find(':'), pattern.size());
        const WordMatch match = findWord(words, trim(pattern.substr(0, colon)));
        letters += match.found ? words[match.index].name.front() : '?';
        more = colon < pattern.size();
        pattern.remove_prefix(more ? colon + 1 : colon);
    }
    return letters;
}

void understandInvariants(StatementReader& reader, F& arguments) {
    if (!reader.has("INVARIANTS")) return;
    const std::string pattern = shortenPattern(arguments.invariants.text);
    arguments.constantCoupling = pattern == "TTFFFTTFF";
    if (arguments.constantCoupling || pattern == "TTTTFTTTF") return;
    reader.addError(arguments.invariants.offset,
                    fmt::format("INVARIANTS of {}: {} is not supported; write T:T:T:T:F:T:T:T:F for partial "
                                "coupling or T:T:F:F:F:T:T:F:F for constant coupling",
                                reader.getName(), quote(arguments.invariants.text)));
}

}  // namespace

void readFlexBody(StatementReader& reader) {
    ReadState& state = reader.updState();
    FlexBodyArguments arguments;
    state.precedingOwner = {"FLEX_BODY", reader.getId()};
    const bool good = reader.readStatement(getFlexBodyTable(), arguments);
    checkModes(reader, arguments, good);
    understandFile(reader, arguments);
    understandRatio(reader, arguments);
    understandInvariants(reader, arguments);
    checkOrientation(reader, "ZG", "XG");
    if (!reader.hasErrors()) state.dataset.flexBodies.push_back(arguments);
}

}  // namespace jprim
