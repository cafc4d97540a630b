// SPDX-License-Identifier: Apache-2.0
// What changes no motion, or only the numerical method, is kept as text.
#include "dataset/statements/ignored.h"

#include "base/format.h"
#include "dataset/statements/statements.h"

namespace jprim {

void readIgnored(StatementReader& reader) {
    reader.registerId();
    if (reader.hasErrors()) return;
    ReadState& state = reader.updState();
    state.outcomes.back() = Outcome::Ignored;
    state.dataset.ignored.push_back(
        {reader.getPosition(), std::string(reader.getKeyword()), reader.getId(), reader.readRawArguments()});
}

namespace {

void readMrequest(StatementReader& reader) {
    readIgnored(reader);
    if (!reader.hasErrors())
        reader.addWarning(
            0, reader.getName() + " writes nothing here; write a REQUEST for each pair of markers");
}

// The text is a list of items, each followed by ", "; it may be broken between them.
void write(StatementWriter& writer, const IgnoredStatement& s) {
    writer.begin(s.keyword, s.id);
    std::string_view rest = s.arguments;
    while (!rest.empty()) {
        const std::size_t end = findItemEnd(rest, 0);
        writer.add(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 2, rest.size()));
    }
    writer.end();
}

}  // namespace

void writeIgnored(StatementWriter& writer, const Dataset& dataset) {
    for (const IgnoredStatement& s : dataset.ignored) write(writer, s);
}

bool areIgnoredEqual(const Dataset& a, const Dataset& b) {
    return std::equal(a.ignored.begin(), a.ignored.end(), b.ignored.begin(), b.ignored.end(),
                      [](const IgnoredStatement& x, const IgnoredStatement& y) {
                          return x.keyword == y.keyword && x.id == y.id && x.arguments == y.arguments;
                      });
}

StatementKind describeIgnored(std::string_view name, std::size_t minimum, bool hasId) {
    return {name, minimum, hasId, true, readIgnored, {}, {}};
}

StatementKind describeMrequest() {
    return {"MREQUEST", 2, true, true, readMrequest, {}, {}};
}

}  // namespace jprim
