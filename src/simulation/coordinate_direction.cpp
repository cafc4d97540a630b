// SPDX-License-Identifier: Apache-2.0
#include "simulation/coordinate_direction.h"

namespace jprim {

void addCoordinateDirections(const MarkerExpression& q, const SimTK::State& state, Directions& directions) {
    Evaluation evaluation(q.program);
    q.setInputs(state, evaluation);
    evaluation.calcValue();
    evaluation.calcGradient();
    std::vector<MarkerMotion> motions(q.markers.size());
    for (size_t k = 0; k < motions.size(); ++k) motions[k].X = q.markers[k].findPoseInGround(state);
    for (size_t k = 0; k < motions.size(); ++k)
        q.markers[k].applyLoad(state, q.getDirection(evaluation, motions.data(), int(k)), directions.onBodies,
                               directions.onSpeeds);
}

}  // namespace jprim
