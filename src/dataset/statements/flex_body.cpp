// SPDX-License-Identifier: Apache-2.0
// FLEX_BODY: a body that bends.
#include <algorithm>

#include "base/format.h"
#include "base/numbers.h"
#include "base/text.h"
#include "dataset/statements/body_fields.h"
#include "dataset/statements/statements.h"

namespace jprim {
namespace {

using Kind = ArgumentKind;
using S = FlexBodyStatement;
using V = ArgumentValue;

// Modes in formats of Adams; checkModes() refuses them, once for all.
constexpr Word AdamsModes[] = {{"MNF_FILE", 2},       {"DB_FILE", 2},        {"BDF_FILE", 2},
                               {"GENSTIFF", 2},       {"INVAR1", ExactOnly}, {"INVAR2", ExactOnly},
                               {"INVAR3", ExactOnly}, {"INVAR4", ExactOnly}, {"INVAR5", ExactOnly},
                               {"INVAR6", ExactOnly}, {"INVAR7", ExactOnly}, {"INVAR8", ExactOnly},
                               {"INVAR9", ExactOnly}, {"T_MODE", 2},         {"R_MODE", 2},
                               {"SELNOD", 4},         {"SELMOD", 4}};

std::vector<Field<S>> adamsFields() {
    std::vector<Field<S>> fields;
    for (const Word& word : AdamsModes)
        fields.emplace_back(ArgumentRule(word.name, Kind::Ignored, word.minimum));
    return fields;
}

// A name with marks that mean something elsewhere stands in quotes of the kind that it does not contain.
std::string quoteName(const std::string& name) {
    if (name.find_first_of(" \t\r\v\f'\",;&!") == name.npos) return name;
    const char mark = name.find('"') == name.npos ? '"' : '\'';
    return mark + name + mark;
}

Field<S> fileField() {
    Field<S> file = field({"MODES_FILE", Kind::Text, 3}, &S::modesFile);
    file.write = [](StatementWriter& writer, const S& s) {
        writer.add("MODES_FILE", quoteName(s.modesFile));
    };
    return file;
}

Field<S> invariantsField() {
    Field<S> invariants = field({"INVARIANTS", Kind::Text, 3}, &S::constantCoupling);
    invariants.write = [](StatementWriter& writer, const S& s) {
        if (s.constantCoupling) writer.add("INVARIANTS=T:T:F:F:F:T:T:F:F");
    };
    return invariants;
}

Field<S> ratioField() {
    Field<S> ratio({"CRATIO", Kind::Expression, 2});
    ratio.write = [](StatementWriter& writer, const S& s) {
        if (s.cratio) writer.addExpression("CRATIO", fmt::format("{}", *s.cratio));
    };
    ratio.equal = [](const S& a, const S& b) { return a.cratio == b.cratio; };
    return ratio;
}

const FieldTable<S>& getFields() {
    static const FieldTable<S> fields = {fileField(),
                                         poseFields(),
                                         velocityFields(),
                                         rotationFields(),
                                         exactField(true),
                                         invariantsField(),
                                         ratioField(),
                                         ArgumentRule("CHAR_LEN", Kind::Ignored, 2),
                                         ArgumentRule("DMODE", Kind::Unsupported, 2),
                                         adamsFields()};
    return fields;
}

// The statement, and beside it what is understood only when all is read.
struct FlexBodyArguments : S {
    std::string ratio, invariants;
};
using F = FlexBodyArguments;

const FieldTable<F>& getArguments() {
    static const FieldTable<F> arguments =
        FieldTable<F>{getFields()}
            .onRead("CRATIO", [](F& f, const V& given) { f.ratio = given.expression.text; })
            .onRead("INVARIANTS", [](F& f, const V& given) { f.invariants = given.text; });
    return arguments;
}

void checkModes(StatementReader& reader, bool isGood) {
    const Word* first = nullptr;
    for (const Word& word : AdamsModes)
        if (reader.has(word.name) && (!first || reader.getOffset(word.name) < reader.getOffset(first->name)))
            first = &word;
    if (first)
        reader.addError(reader.getOffset(first->name),
                        fmt::format("{} of {}: modes in a format of Adams cannot be read, because it is "
                                    "closed; let 'jprim reduce' make a file of modes from a finite-element "
                                    "mesh and name it: MODES_FILE=",
                                    first->name, reader.getName()));
    else
        reader.checkNeeded("MODES_FILE", isGood);
}

// A file name as given; one in quotes may have blanks, and quotes of the other kind.
void understandFile(StatementReader& reader, F& arguments) {
    if (!reader.has("MODES_FILE")) return;
    std::string_view name = arguments.modesFile;
    std::string_view forbidden = " \t\r\v\f\"'";
    if (name.size() > 1 && name.front() == name.back() && (name.front() == '"' || name.front() == '\'')) {
        forbidden = name.front() == '"' ? "\"" : "'";
        name = name.substr(1, name.size() - 2);
    }
    if (name.empty() || name.find_first_of(forbidden) != name.npos)
        reader.addError(reader.getValueOffset("MODES_FILE"),
                        fmt::format("MODES_FILE of {}: {} is not a file name; one with blanks stands in "
                                    "quotes, one with a comma, semicolon, & or ! in double ones",
                                    reader.getName(), quote(arguments.modesFile)));
    arguments.modesFile = std::string(name);
}

void understandRatio(StatementReader& reader, F& arguments) {
    if (arguments.ratio.empty()) return;  // not given, or already reported
    const Number<double> ratio = parseReal(arguments.ratio, false);
    arguments.cratio = ratio.value;
    if (!ratio.fault.empty())
        reader.addError(
            reader.getValueOffset("CRATIO"),
            fmt::format("CRATIO of {}: {}; only a number is supported here", reader.getName(), ratio.fault));
    else if (ratio.value < 0)
        reader.addError(
            reader.getValueOffset("CRATIO"),
            fmt::format("CRATIO of {} is {}; damping cannot be negative", reader.getName(), ratio.value));
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
    const std::string pattern = shortenPattern(arguments.invariants);
    arguments.constantCoupling = pattern == "TTFFFTTFF";
    if (arguments.constantCoupling || pattern == "TTTTFTTTF") return;
    reader.addError(reader.getValueOffset("INVARIANTS"),
                    fmt::format("INVARIANTS of {}: {} is not supported; write T:T:T:T:F:T:T:T:F for partial "
                                "coupling or T:T:F:F:F:T:T:F:F for constant coupling",
                                reader.getName(), quote(arguments.invariants)));
}

void read(StatementReader& reader) {
    ReadState& state = reader.updState();
    F arguments;
    state.precedingOwner = {"FLEX_BODY", reader.getId()};
    const bool isGood = reader.readStatement(getArguments(), arguments);
    checkModes(reader, isGood);
    understandFile(reader, arguments);
    understandRatio(reader, arguments);
    understandInvariants(reader, arguments);
    checkOrientation(reader, "ZG", "XG");
    if (!reader.hasErrors()) state.dataset.flexBodies.push_back(arguments);
}

}  // namespace

StatementKind describeFlexBody() {
    return readBy(read, makeKind("FLEX_BODY", 2, getFields(), &Dataset::flexBodies));
}

}  // namespace jprim
