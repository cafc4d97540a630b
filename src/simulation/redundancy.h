// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_SIMULATION_REDUNDANCY_H_
#define JPRIM_SRC_SIMULATION_REDUNDANCY_H_

#include <string>
#include <vector>

#include "jprim/build/mechanism.h"

namespace jprim {

/// The redundant equations of a mechanism, switched off as Adams does, and watched: they must go on being
/// satisfied by what the others hold.
class DroppedEquations {
public:
    /// Drops the later ones of equations that depend on each other in the State, realized to Stage::Position,
    /// and nearby; those that depend only there stay.
    DroppedEquations(const Mechanism& mechanism, SimTK::State& state);

    /// In words: "JOINT/4 TRANSLATIONAL: translation of I along Yj".
    const std::vector<std::string>& getTexts() const { return m_texts; }

    /// @throws std::runtime_error naming the equation that is violated by more than `tolerance` [the
    ///         mechanism's length unit, rad] and by how much. Requires Stage::Position.
    void check(const SimTK::State& state, SimTK::Real tolerance) const;

private:
    struct Dropped {
        Primitive primitive;
        int equation = 0;
    };
    SimTK::Real m_lengthUnit;  // of the dataset
    std::vector<Dropped> m_dropped;
    std::vector<std::string> m_texts;
};

}  // namespace jprim

#endif
