// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_DATASET_LANGUAGE_READ_STATE_H_
#define JPRIM_SRC_DATASET_LANGUAGE_READ_STATE_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "dataset/language/arguments.h"
#include "jprim/base/diagnostic.h"
#include "jprim/dataset/dataset.h"

namespace jprim {

/// What became of one statement.
enum class Outcome : std::uint8_t { Built, Ignored, Error };

/// What a marker is on: PART/2, POINT_MASS/2 or FLEX_BODY/2, which are not the same.
struct Owner {
    std::string_view keyword;  ///< in full; empty if there is none
    int id = 0;                ///< 0 if it was unreadable

    std::string getName() const;
};

/// Where the statement with an id stands, and what is known of it if it is a MARKER.
struct IdEntry {
    std::size_t statement = 0;  ///< counts the file's statements from 0
    int line = 0;
    Owner owner;
    bool floating = false;
};

/// Adams' ids are small consecutive numbers, and a hostile file could choose ones that all fall into the
/// same slot of a table; mixing the bits makes that impractical.
struct IdHash {
    std::size_t operator()(int id) const {
        std::uint64_t x = static_cast<std::uint64_t>(id) * 0x9e3779b97f4a7c15u;
        x = (x ^ (x >> 32)) * 0xd6e8feb86659fd93u;
        return static_cast<std::size_t>(x ^ (x >> 32));
    }
};
using IdMap = std::unordered_map<int, IdEntry, IdHash>;

/// A mention of another statement, checked when the whole file is known, because it may come before the
/// statement it names.
struct Reference {
    std::size_t statement = 0;  ///< counts the file's statements from 0
    std::string_view keyword;   ///< the statement that mentions it: JPRIM
    int ownId = 0;              ///< and its id
    int id = 0;                 ///< the id mentioned
    const ArgumentRule* rule = nullptr;
    SourcePosition where;
    bool anyOwner = false;  ///< the link that the rule asks for need not hold
};

/// A MOTION's or COUPLER's use of one coordinate of a joint, checked when the joint's type is known.
struct JointUse {
    std::size_t statement = 0;
    std::string argument;  ///< as messages name it: JOINT of MOTION/3
    int joint = 0;
    std::optional<CouplerType> coordinate;  ///< the joint's only one if empty
    SourcePosition where;
    const char* remedy = "";  ///< how to say which coordinate is meant
};

/// Everything that is known while a file is read.
struct ReadState {
    explicit ReadState(Diagnostics& d) : diagnostics(d) {}

    Dataset dataset;
    Diagnostics& diagnostics;
    std::vector<Outcome> outcomes;                    ///< one for each statement so far
    std::unordered_map<std::string_view, IdMap> ids;  ///< by full keyword
    std::vector<Reference> references;
    std::vector<JointUse> jointUses;
    Owner precedingOwner;     ///< the default owner of a MARKER
    SourcePosition ground;    ///< the GROUND part, once one was found
    bool partFailed = false;  ///< a PART has errors, so nothing is sure about the parts

    void addError(std::size_t statement, SourcePosition where, std::string message);
};

/// Checks that every reference names what exists and what it may name.
void checkReferences(ReadState& state);

/// Checks that the joints used have the coordinates, and gives every COUPLER its types.
void checkJointUses(ReadState& state);

}  // namespace jprim

#endif
