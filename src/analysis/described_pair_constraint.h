// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_ANALYSIS_DESCRIBED_PAIR_CONSTRAINT_H_
#define JPRIM_SRC_ANALYSIS_DESCRIBED_PAIR_CONSTRAINT_H_

#include "general/general_constraint_impl.h"
#include "primitive/pair_constraint_impl.h"

namespace jprim {

/// Opens Simbody's handle of a Custom constraint, which shows its Implementation to derived classes only.
struct CustomHandle : SimTK::Constraint::Custom {
    explicit CustomHandle(const Custom& constraint) : Custom(constraint) {}
    using Custom::getImplementation;
};

/// The constraint's Implementation if it is of this class, or null.
template <class Implementation>
const Implementation* findImplementation(const SimTK::Constraint& constraint) {
    using Custom = SimTK::Constraint::Custom;
    if (!Custom::isInstanceOf(constraint)) return nullptr;
    return dynamic_cast<const Implementation*>(
        &CustomHandle(Custom::downcast(constraint)).getImplementation());
}

/// The primitive or joint that a constraint is, or null.
inline const PairConstraintImpl* findPairConstraint(const SimTK::Constraint& constraint) {
    return findImplementation<PairConstraintImpl>(constraint);
}

}  // namespace jprim

#endif
