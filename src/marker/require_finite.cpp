// SPDX-License-Identifier: Apache-2.0
#include "marker/require_finite.h"

#include <cmath>

#include "base/format.h"
#include "jprim/base/error.h"

namespace jprim {

using SimTK::Real;
using SimTK::Transform;
using SimTK::Vec3;

void requireFinite(Real value, const std::string& what, const std::string& element) {
    if (!std::isfinite(value))
        throw Error(element, fmt::format("its {} is {}; it must be a finite number", what, value));
}

void requireFinite(const Transform& X, const std::string& whose, const std::string& element) {
    const auto require = [&](const Vec3& v, const char* what) {
        if (!v.isFinite())
            throw Error(element, fmt::format("{} {} is ({}, {}, {}); it must be finite", whose, what, v[0],
                                             v[1], v[2]));
    };
    require(X.p(), "place");
    require(Vec3(X.R().x()), "x axis");
    require(Vec3(X.R().y()), "y axis");
    require(Vec3(X.R().z()), "z axis");
}

}  // namespace jprim
