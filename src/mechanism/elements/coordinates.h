// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MECHANISM_ELEMENTS_COORDINATES_H_
#define JPRIM_SRC_MECHANISM_ELEMENTS_COORDINATES_H_

#include "jprim/joint/motion.h"
#include "mechanism/elements/element_context.h"

namespace jprim {

/// The markers and coordinate that a MOTION prescribes.
struct MotionCoordinate {
    int i = 0;
    int j = 0;
    Coordinate coordinate = Coordinate::Z;
};
[[nodiscard]] MotionCoordinate findMotionCoordinate(const MotionStatement& statement,
                                                    const ElementContext& context);

/// The coordinates that are given at the start: ICDISP and ICVEL of MOTIONs, IC of JOINTs.
[[nodiscard]] std::vector<InitialCoordinate> makeInitialCoordinates(const ElementContext& context);

}  // namespace jprim

#endif
