// SPDX-License-Identifier: Apache-2.0
#include "build/length_unit.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace jprim {

double chooseLengthUnit(const Dataset& dataset, double lengthToSI) {
    std::unordered_map<int, Triple> origins;
    for (const MarkerStatement& marker : dataset.markers) origins[marker.id] = marker.qp.value_or(Triple{});
    std::unordered_map<int, Triple> centers;
    for (const PartStatement& part : dataset.parts)
        if (!part.ground && part.cm != 0) centers[part.id] = origins[part.cm];

    double largest = 0;
    for (const MarkerStatement& marker : dataset.markers) {
        const auto center = centers.find(marker.part);
        if (center == centers.end()) continue;
        const Triple& a = origins[marker.id];
        const Triple& b = center->second;
        largest = std::max(largest, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    }
    if (largest == 0 || !std::isfinite(largest * lengthToSI)) return 1;
    return std::pow(1000., std::round(std::log10(largest * lengthToSI) / 3));
}

}  // namespace jprim
