// SPDX-License-Identifier: Apache-2.0
#include "dataset/body_arguments.h"

#include "base/format.h"

namespace jprim {

const std::vector<Word>& getCoordinateNames() {
    static const std::vector<Word> words = {{"X"}, {"Y"}, {"Z"}, {"PSI"}, {"THETA"}, {"PHI"}};
    return words;
}

void checkMass(StatementReader& reader, const std::optional<double>& mass, int cm) {
    if (mass && *mass < 0)
        reader.addError(reader.getOffset("MASS"),
                        fmt::format("MASS of {} is {}; a mass cannot be negative", reader.getName(), *mass));
    if (mass && *mass > 0 && cm == 0)
        reader.addError(
            0, fmt::format("{} has a MASS but no mass centre; name its marker: CM=", reader.getName()));
}

void checkNotBoth(StatementReader& reader, const char* name, const char* other) {
    if (reader.has(name) && reader.has(other))
        reader.addError(reader.getOffset(name),
                        fmt::format("{} takes {} or {}, not both", reader.getName(), name, other));
}

void checkOrientation(StatementReader& reader, const char* z, const char* x) {
    checkNotBoth(reader, "REULER", z);
    checkNotBoth(reader, "REULER", x);
}

}  // namespace jprim
