#pragma once
#include <rayscope/ray.h>
#include <rayscope/scene.h>
#include <rayscope/settings.h>

namespace rayscope::trace {

/// A thin-lens or pinhole camera over an image of width × height pixels, computed in double.
class Camera {
  public:
    Camera() = default;
    Camera(const CameraDescription& description, int width, int height);

    /// The ray through the pixel coordinates (x to the right, y downwards, pixel centres at half-integers)
    /// and the centre of the lens. Its direction has unit length.
    Ray pinholeRay(const glm::dvec2& pixel) const {
        return {glm::vec3(position_), glm::vec3(towards(onImagePlane(pixel)))};
    }

    /// The ray that starts at a point of the aperture (in units of its radius) and intersects the pinhole
    /// ray in the plane of focus. At the centre of the aperture, bit for bit the pinhole ray.
    Ray lensRay(const glm::dvec2& pixel, const glm::dvec2& aperture) const;

    /// Distance of a point from the camera along the viewing direction.
    double depthOf(const glm::dvec3& point) const { return glm::dot(point - position_, forward_); }
    /// Pixel coordinates of a point in front of the camera.
    glm::dvec2 project(const glm::dvec3& point) const;

    bool hasLens() const { return lensRadius_ > 0.0; }
    double lensRadius() const { return lensRadius_; }
    double focusDistance() const { return focusDistance_; }
    /// Angle between the rays of neighbouring pixels at the centre of the image, radians.
    double pixelAngle() const { return pixelSize_.y; }

  private:
    glm::dvec2 onImagePlane(const glm::dvec2& pixel) const {
        return {pixel.x * pixelSize_.x - tanHalfX_, tanHalfY_ - pixel.y * pixelSize_.y};
    }
    /// Unit direction through a point of the image plane at distance 1.
    glm::dvec3 towards(const glm::dvec2& plane) const {
        return glm::normalize(forward_ + plane.x * right_ + plane.y * up_);
    }

    glm::dvec3 position_{0.0}, right_{1.0, 0.0, 0.0}, up_{0.0, 1.0, 0.0}, forward_{0.0, 0.0, -1.0};
    double tanHalfX_ = 1.0, tanHalfY_ = 1.0;
    glm::dvec2 pixelSize_{2.0};  ///< on the image plane at distance 1
    double lensRadius_ = 0.0, focusDistance_ = 1.0, inverseFocusDistance_ = 1.0;
    int width_ = 1, height_ = 1;
};

}  // namespace rayscope::trace
