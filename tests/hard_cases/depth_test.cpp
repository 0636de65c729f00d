// Visibility with difficult depths, compared with double-precision ray casting against every triangle and
// with closed forms.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "base/gl/context.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/mesh/clusters.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/until_stopped.h"
#include "pipeline/stages/vertex_coordinates.h"
#include "pipeline/visibility/frame_triangles.h"
#include "pipeline/visibility/gl_geometry.h"
#include "pipeline/visibility/photo_geometry.h"
#include "pipeline/visibility/rasterize.h"
#include "player/plan/cluster_tree.h"
#include "player/render/picture.h"
#include "scene/package/package_reader.h"
#include "tests/hard_cases/special_numbers.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;

namespace {

const Intrinsics depth_camera{150, 110, 120, 125, 71.3, 57.6};

/// Unconnected triangles.
struct Soup {
    std::vector<Eigen::Vector3f> positions;
    std::vector<std::uint32_t> indices;

    void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
        for (const Eigen::Vector3d& p : {a, b, c}) {
            indices.push_back(std::uint32_t(positions.size()));
            positions.push_back(p.cast<float>());
        }
    }
    void add_square(const Eigen::Vector3d& corner, const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
        add(corner, corner + u, corner + u + v);
        add(corner, corner + u + v, corner + v);
    }
};

/// Distance to a two-sided triangle along `ray`, in lengths of `ray`; `infinite` if it is missed.
double met_at(const Eigen::Vector3d& from, const Eigen::Vector3d& ray,
              const std::array<Eigen::Vector3d, 3>& p) {
    const Eigen::Vector3d a = p[0] - from, b = p[1] - from, c = p[2] - from;
    const double u = ray.dot(b.cross(c)), v = ray.dot(c.cross(a)), w = ray.dot(a.cross(b));
    if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) || u + v + w == 0) return infinite;
    const double t = a.dot((p[1] - p[0]).cross(p[2] - p[0])) / (u + v + w);
    return t > 0 ? t : infinite;
}

/// Brute-force ray casting against triangles, in the order of `indices`.
class Rays {
  public:
    Rays(std::span<const Eigen::Vector3f> positions, std::span<const std::uint32_t> indices) {
        for (std::size_t t = 0; t < indices.size(); t += 3)
            triangles_.push_back({positions[indices[t]].cast<double>(),
                                  positions[indices[t + 1]].cast<double>(),
                                  positions[indices[t + 2]].cast<double>()});
    }
    double first(const Eigen::Vector3d& from, const Eigen::Vector3d& ray) const {
        double nearest = infinite;
        for (const auto& t : triangles_) nearest = std::min(nearest, met_at(from, ray, t));
        return nearest;
    }
    double at(std::size_t triangle, const Eigen::Vector3d& from, const Eigen::Vector3d& ray) const {
        return met_at(from, ray, triangles_[triangle]);
    }

  private:
    std::vector<std::array<Eigen::Vector3d, 3>> triangles_;
};

/// A pixel's ray in the world, scaled to unit depth.
Eigen::Vector3d ray_of(const Intrinsics& k, const Pose& pose, double u, double v) {
    return pose.R.transpose() * Eigen::Vector3d((u - k.cx) / k.fx, (v - k.cy) / k.fy, 1);
}

class Depth : public TemporaryFolder {
  protected:
    const gl::HeadlessContext context{gl::Debug::on};

    struct Seen {
        const char* by;
        PhotoGeometry geometry;
    };
    /// Rendered by both renderers, from the clusters that intersect the frame.
    static std::vector<Seen> seen(Soup soup, const Intrinsics& k, const Pose& pose) {
        const auto clusters = make_clusters(soup.positions, soup.indices, 64);
        const FrameTriangles in_frame = triangles_in_frame(clusters, soup.indices, k, pose);
        const Eigen::Vector2d range = depth_range(soup.positions, pose);
        const std::vector<Eigen::Vector3f> normals(soup.positions.size(), {0, 0, -1});
        const PhotoProjection p = project_model(soup.positions, map_intrinsics(k), pose, range.x());
        return {{"processor", rasterize_geometry(p, normals, in_frame.indices)},
                {"OpenGL",
                 render_geometry(upload_model(soup.positions, normals), in_frame.indices, k, pose, range)}};
    }
    static std::vector<Eigen::Vector2f> coordinates(const Soup& soup, const Intrinsics& k, const Pose& pose) {
        return vertex_coordinates(
            project_model(soup.positions, map_intrinsics(k), pose, depth_range(soup.positions, pose).x()),
            soup.indices, k);
    }

    /// Counts depths outside the range that rays find within `reach` map pixels.
    static std::size_t count_wrong(const PhotoGeometry& g, const Soup& soup, const Intrinsics& k,
                                   const Pose& pose, double reach) {
        const Rays rays(soup.positions, soup.indices);
        const Intrinsics map = map_intrinsics(k);
        const Eigen::Vector3d eye = pose.center();
        std::size_t wrong = 0;
        for (int y = 0; y < g.height; ++y)
            for (int x = 0; x < g.width; ++x) {
                double least = infinite, most = 0;
                for (const auto& [dx, dy] : {std::pair(0, 0),
                                             {-1, -1},
                                             {1, -1},
                                             {-1, 1},
                                             {1, 1},
                                             {0, 1},
                                             {0, -1},
                                             {1, 0},
                                             {-1, 0}}) {
                    const double z =
                        rays.first(eye, ray_of(map, pose, x + 0.5 + dx * reach, y + 0.5 + dy * reach));
                    least = std::min(least, z);
                    most = std::max(most, z);
                }
                const double z = double(g.z[std::size_t(y) * std::size_t(g.width) + std::size_t(x)]);
                wrong += !(z > 0) || !(z >= least * (1 - 1e-4) && z <= most * (1 + 1e-4));
            }
        return wrong;
    }
};

class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double operator()(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    Eigen::Vector3d vector() { return {(*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1)}; }
    Eigen::Matrix3d rotation() {
        return Eigen::AngleAxisd((*this)(0, 3), vector().normalized()).toRotationMatrix();
    }

  private:
    std::mt19937 engine_;
};

}  // namespace

TEST_F(Depth, EveryPixelMatchesItsFirstRayHit) {
    // Large and small triangles and slivers around the camera, some behind it or crossing its plane.
    for (unsigned seed = 1; seed <= 6; ++seed) {
        Random random(seed);
        Soup soup;
        for (int t = 0; t < 160; ++t) {
            const double size = std::pow(10, random(-1.5, t % 8 ? 0.3 : 1.3));
            const Eigen::Vector3d center = 5 * random.vector();
            const Eigen::Vector3d a = center + size * random.vector(), b = center + size * random.vector();
            const Eigen::Vector3d along = a + random(0, 1) * (b - a);
            soup.add(a, b, t % 3 ? center + size * random.vector() : along + 1e-4 * size * random.vector());
        }
        const Pose pose{random.rotation(), 0.5 * random.vector()};
        for (const Seen& s : seen(soup, depth_camera, pose))
            EXPECT_EQ(count_wrong(s.geometry, soup, depth_camera, pose, 1 / 64.0), 0u)
                << s.by << " seed " << seed;
    }
}

TEST_F(Depth, DepthsAreExactOverANearFarRatioOfAMillion) {
    // Around the camera, so that single precision suffices for near surfaces, too. Each strip of the frame
    // has its own distance, and a second surface a thousandth behind the first.
    Soup soup;
    for (const double side : {-1.0, 1.0})
        for (int strip = 0; strip < 7; ++strip) {
            const double z = side * std::pow(10, strip);
            for (const double behind : {1.001, 1.0})
                soup.add_square(
                    behind * z *
                        Eigen::Vector3d((10 + 20 * strip - depth_camera.cx) / depth_camera.fx, -1, 1),
                    behind * z * Eigen::Vector3d(19 / depth_camera.fx, 0, 0),
                    behind * z * Eigen::Vector3d(0, 2, 0));
        }
    for (const Seen& s : seen(soup, depth_camera, Pose{}))
        for (int y = 0; y < s.geometry.height; ++y)
            for (int strip = 0; strip < 7; ++strip) {
                const auto x = std::size_t(5 + 10 * strip + 4);
                const double z = std::pow(10, strip);
                ASSERT_NEAR(s.geometry.z[std::size_t(y) * std::size_t(s.geometry.width) + x], z, 1e-4 * z)
                    << s.by << " row " << y;
            }
}

TEST_F(Depth, ClosedModelHasNoHolesFromInside) {
    // A cube around the camera, which is close to one side.
    const double half = 4;
    Soup soup;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-half, half}) {
            Eigen::Vector3d corner = Eigen::Vector3d::Constant(-half), u = Eigen::Vector3d::Zero(), v = u;
            corner[axis] = side;
            u[(axis + 1) % 3] = v[(axis + 2) % 3] = 2 * half;
            soup.add_square(corner, u, v);
        }
    Random random(5);
    for (int turn = 0; turn < 8; ++turn) {
        const Eigen::Vector3d eye(3.9, random(-3.9, 3.9), 3.98);
        Pose pose{random.rotation(), {}};
        pose.t = -pose.R * eye;
        for (const Seen& s : seen(soup, depth_camera, pose)) {
            // OpenGL has only 24-bit positions, some of which the offset to the near side uses up.
            EXPECT_LE(count_wrong(s.geometry, soup, depth_camera, pose, 1 / 64.0), s.by[0] == 'O' ? 4u : 0u)
                << s.by << " turn " << turn;
            EXPECT_TRUE(std::ranges::all_of(s.geometry.z, [](float z) { return std::isfinite(z); })) << s.by;
        }
        const auto found = coordinates(soup, depth_camera, pose);
        for (std::size_t v = 0; v < found.size(); ++v) {
            const auto at = project(depth_camera, pose, soup.positions[v].cast<double>());
            EXPECT_EQ(found[v].x() >= 0, at && in_frame(depth_camera, at->pixel))
                << "turn " << turn << " vertex " << v;
        }
    }
}

TEST_F(Depth, HugeFloorKeepsItsDepth) {
    Soup soup;
    soup.add({-1e6, 1, -3}, {2e6, 1, -7}, {-3e5, 1, 10});
    for (const Seen& s : seen(soup, depth_camera, Pose{}))
        EXPECT_EQ(count_wrong(s.geometry, soup, depth_camera, Pose{}, 1 / 64.0), 0u) << s.by;
}

TEST_F(Depth, NoTriangleOccludesItsOwnVertices) {
    Random random(8);
    Intrinsics tele = depth_camera;  // a pixel's footprint is smaller than a float's last digit
    tele.fx = tele.fy = 1e8;
    for (int trial = 0; trial < 20000; ++trial) {
        const Intrinsics& k = trial % 2 ? tele : depth_camera;
        // Slivers of the smallest areas that are rasterized, with corners at different depths.
        const double reach = trial % 4 < 2 ? 100 : 3;
        const Eigen::Vector2d a(random(5, 145), random(5, 105)),
            b = a + reach * Eigen::Vector2d(random(-1, 1), random(-1, 1));
        const Eigen::Vector2d across = Eigen::Vector2d(a.y() - b.y(), b.x() - a.x()).normalized();
        const Eigen::Vector2d c = a + random(0, 1) * (b - a) + std::pow(10, random(-4.5, -1)) * across;
        const auto at_depth = [&](const Eigen::Vector2d& p) -> Eigen::Vector3d {
            return std::pow(10, random(0, 2)) * ray_of(k, Pose{}, p.x(), p.y());
        };
        Soup soup;
        soup.add(at_depth(a), at_depth(b), at_depth(c));
        const auto found = coordinates(soup, k, Pose{});
        for (std::size_t v = 0; v < 3; ++v) {
            const auto at = project(k, Pose{}, soup.positions[v].cast<double>());
            ASSERT_EQ(found[v].x() >= 0, at && in_frame(k, at->pixel)) << "trial " << trial;
        }
    }
}

TEST_F(Depth, GeometryBehindTheCameraIsNotSeen) {
    Soup soup;
    soup.add_square({-2, -2, -3}, {4, 0, 0}, {0, 4, 0});
    soup.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});     // touching the camera, in its plane
    soup.add({-1, -1, 0}, {1, -1, 0}, {0, 1, 0});  // in its plane, around the camera
    soup.add({0, 0, 0}, {1, 0, -1}, {0, 1, -1});   // from its center backwards
    EXPECT_EQ(depth_range(soup.positions, Pose{}), Eigen::Vector2d(0, 0));
    for (const Seen& s : seen(soup, depth_camera, Pose{}))
        for (const float z : s.geometry.z) ASSERT_TRUE(std::isinf(z) && z > 0) << s.by;
    for (const auto& uv : coordinates(soup, depth_camera, Pose{})) EXPECT_EQ(uv, Eigen::Vector2f(-1, -1));
    const PhotoProjection nothing = project_model(soup.positions, map_intrinsics(depth_camera), Pose{}, 0);
    for (std::size_t i = 0; i < soup.indices.size(); i += 3)
        EXPECT_EQ(clipped(nothing, &soup.indices[i]).count, 0) << "nothing is left of pieces infinitely near";
}

TEST_F(Depth, SurfacesOccludeEachOtherBeyondAThirdOfAPixel) {
    // Distance along the line of sight, in pixel footprints; occlusion begins at a third.
    const Intrinsics k{400, 300, 380, 380, 201.7, 148.2};
    for (const double tilt : {0.0, 0.6, -1.1})
        for (const double apart : {1.0, 0.5, 0.2, 0.0}) {
            Soup soup;
            const Eigen::Matrix3d R = Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitY()).toRotationMatrix();
            const auto point = [&](int i, int j) -> Eigen::Vector3d {
                return R * Eigen::Vector3d(0.25 * i, 0.25 * j, 0) + Eigen::Vector3d(0.011, 0.017, 20);
            };
            const double shares[] = {1, 1 + apart / k.fx};
            for (const double share : shares)
                for (int j = -16; j < 16; ++j)
                    for (int i = -24; i < 24; ++i) {
                        // The far corners lie behind the interiors of near triangles.
                        const auto at = [&](int di, int dj) -> Eigen::Vector3d {
                            const Eigen::Vector3d p = point(i + di, j + dj);
                            return share * (share > 1 ? p + R * Eigen::Vector3d(0.08, 0.11, 0) : p);
                        };
                        soup.add(at(0, 0), at(1, 0), at(1, 1));
                        soup.add(at(0, 0), at(1, 1), at(0, 1));
                    }
            const auto found = coordinates(soup, k, Pose{});
            std::size_t near_hidden = 0, far_seen = 0, far = 0;
            for (std::size_t v = 0; v < found.size(); ++v) {
                const Eigen::Vector3d p = soup.positions[v].cast<double>();
                const Eigen::Vector3d on_plane = R.transpose() * (p - point(0, 0));
                if (v < found.size() / 2) {
                    near_hidden += found[v].x() < 0;
                } else if (std::abs(on_plane.x()) < 5.5 &&
                           std::abs(on_plane.y()) < 3.5) {  // entirely behind the near one
                    ++far;
                    far_seen += found[v].x() >= 0;
                }
            }
            EXPECT_EQ(near_hidden, 0u) << "apart " << apart << " tilt " << tilt;
            EXPECT_EQ(far_seen, apart > 1 / 3.0 ? 0 : far) << "apart " << apart << " tilt " << tilt;
            for (const Seen& s : seen(soup, k, Pose{})) {
                if (apart < 1) continue;
                for (int y = 20; y < s.geometry.height - 20; ++y)
                    for (int x = 60; x < s.geometry.width - 60; ++x) {
                        const Eigen::Vector3d ray = ray_of(map_intrinsics(k), Pose{}, x + 0.5, y + 0.5);
                        const Eigen::Vector3d n = R.col(2);
                        const double z = n.dot(point(0, 0)) / n.dot(ray);
                        const Eigen::Vector3d on_plane = R.transpose() * (z * ray - point(0, 0));
                        if (std::abs(on_plane.x()) > 5.5 || std::abs(on_plane.y()) > 3.5) continue;
                        ASSERT_LT(s.geometry.z[std::size_t(y * s.geometry.width + x)], z * (1 + 0.5 / k.fx))
                            << s.by << " tilt " << tilt << " at " << x << "," << y;
                    }
            }
        }
}

TEST_F(Depth, FinelyTessellatedSphereDoesNotOccludeItsNearSide) {
    // Its facets lie inside the sphere, so they occlude no line of sight to its near side: exactly the cap up
    // to the horizon is seen, and a little beyond where facets are below the horizon.
    constexpr std::uint32_t rings = 500, sectors = 1000;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t r = 0; r < rings; ++r)
        for (std::uint32_t s = 0; s < sectors; ++s) {
            const std::uint32_t a = r * sectors + s, b = r * sectors + (s + 1) % sectors;
            for (const std::uint32_t v : {a, b, a + sectors, b, b + sectors, a + sectors})
                indices.push_back(v);
        }
    struct Sight {
        double distance, focal;
    };
    // All of it, a part from close by, and its center through long lenses.
    for (const auto& [distance, focal] : {Sight{3, 700}, {1.06, 60}, {40, 15000}, {500, 3e5}}) {
        const Eigen::Vector3d center(0.1, -0.06, distance);
        std::vector<Eigen::Vector3f> positions;
        for (std::uint32_t r = 0; r <= rings; ++r)
            for (std::uint32_t s = 0; s < sectors; ++s) {
                const double polar = M_PI * r / rings, turn = 2 * M_PI * s / sectors;
                const Eigen::Vector3d n(std::sin(polar) * std::cos(turn), std::cos(polar),
                                        std::sin(polar) * std::sin(turn));
                positions.push_back((center + n).cast<float>());
            }
        const Intrinsics k{800, 600, focal, focal, 400, 300};
        const Pose pose;
        const auto found = vertex_coordinates(
            project_model(positions, map_intrinsics(k), pose, depth_range(positions, pose).x()), indices, k);
        std::size_t in_cap = 0, hidden = 0, beyond = 0, shown = 0;
        for (std::size_t v = 0; v < positions.size(); ++v) {
            const Eigen::Vector3d p = positions[v].cast<double>();
            const auto at = project(k, pose, p);
            if (!at || !in_frame(k, at->pixel)) continue;
            // In front of the plane where the tangent cone touches the sphere.
            const double before = -(p - center).dot(p);
            if (before > 1e-6 * distance) ++in_cap, hidden += found[v].x() < 0;
            if (before < -0.03 * p.norm()) ++beyond, shown += found[v].x() >= 0;
        }
        EXPECT_GT(in_cap, 8000u) << distance;
        EXPECT_LT(double(hidden), 1e-4 * double(in_cap)) << "at " << distance << ": of " << in_cap;
        EXPECT_EQ(shown, 0u) << "at " << distance << ": of " << beyond;
    }
}

TEST_F(Depth, VertexVisibilityMatchesRayCastingAtAllDistances) {
    // Triangles and slivers at distances from 1 to a million, of similar sizes in pixels.
    std::size_t visible = 0, hidden = 0, differ = 0;
    for (unsigned seed = 1; seed <= 3; ++seed) {
        Random random(seed);
        Soup soup;
        for (int t = 0; t < 700; ++t) {
            const double z = std::pow(10, random(0, 6)) * (t % 9 ? 1 : -1),
                         size = std::pow(10, random(-2.3, -0.7));
            const auto corner = [&](const Eigen::Vector3d& c) {
                return Eigen::Vector3d(z * (c + size * random.vector()));
            };
            const Eigen::Vector3d c(random(-0.7, 0.7), random(-0.5, 0.5), 1);
            const Eigen::Vector3d a = corner(c), b = corner(c);
            soup.add(a, b,
                     t % 4 ? corner(c)
                           : Eigen::Vector3d(a + random(0, 1) * (b - a) + 1e-3 * size * z * random.vector()));
        }
        const auto found = coordinates(soup, depth_camera, Pose{});
        const Rays rays(soup.positions, soup.indices);
        for (std::size_t v = 0; v < soup.positions.size(); ++v) {
            const Eigen::Vector3d p = soup.positions[v].cast<double>();
            const auto at = project(depth_camera, Pose{}, p);
            if (!at || !in_frame(depth_camera, at->pixel)) {
                EXPECT_EQ(found[v], Eigen::Vector2f(-1, -1)) << "seed " << seed << " vertex " << v;
                continue;
            }
            const bool free = rays.first(Eigen::Vector3d::Zero(), p) > 1 - 0.3 / depth_camera.fy;
            ++(free ? visible : hidden);
            differ += free != (found[v].x() >= 0);
        }
    }
    EXPECT_GT(visible, 300u);
    EXPECT_GT(hidden, 300u);
    EXPECT_EQ(differ, 0u) << "of " << visible + hidden;
}

TEST_F(Depth, FrustumCullingKeepsEveryHitTriangle) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        Soup soup;
        for (int t = 0; t < 400; ++t) {
            const double size = std::pow(10, random(-2, 1.5));
            const Eigen::Vector3d c = 9 * random.vector();
            soup.add(c + size * random.vector(), c + size * random.vector(), c + size * random.vector());
        }
        const Pose pose{random.rotation(), 3 * random.vector()};
        const auto clusters = make_clusters(soup.positions, soup.indices, 1 + seed * 7 % 50);
        std::vector<bool> kept(soup.indices.size() / 3, false), drawn = kept;
        for (const auto& source : triangles_in_frame(clusters, soup.indices, depth_camera, pose).sources)
            kept[source.triangle] = true;
        const View view{depth_camera, pose};
        for (const std::uint32_t c : clusters_in_view(make_cluster_tree(clusters), clusters, view))
            for (std::uint32_t t = 0; t < clusters[c].triangles; ++t)
                drawn[clusters[c].first_triangle + t] = true;
        const Rays rays(soup.positions, soup.indices);
        for (int i = 0; i < 300; ++i) {
            const Eigen::Vector3d ray =
                ray_of(depth_camera, pose, random(0, depth_camera.width), random(0, depth_camera.height));
            for (std::size_t t = 0; t < kept.size(); ++t)
                ASSERT_TRUE(!std::isfinite(rays.at(t, pose.center(), ray)) || (kept[t] && drawn[t]))
                    << "seed " << seed << " triangle " << t;
        }
    }
}

TEST_F(Depth, PlayerShowsTheNearestSurfaceOverANearFarRatioOfAMillion) {
    SynthSpec spec = spec_named("tiny");
    spec.photos.count = 2;
    spec.photos.samples = 1;
    copy_scene(spec, dir / "scene");
    SceneInput scene = read_scene(discover(dir / "scene"));
    const Intrinsics k = scene.photos[0].camera.intrinsics;
    scene.mesh = {};
    const auto add_square = [&](const Eigen::Vector3d& corner, const Eigen::Vector3d& u,
                                const Eigen::Vector3d& v) {
        const auto first = std::uint32_t(scene.mesh.positions.size());
        for (const Eigen::Vector3d& p : {corner, Eigen::Vector3d(corner + u), Eigen::Vector3d(corner + u + v),
                                         Eigen::Vector3d(corner + v)}) {
            scene.mesh.positions.push_back(p);
            scene.mesh.normals.emplace_back(0, 0, -1);
        }
        scene.mesh.triangles.push_back({first, first + 1, first + 2});
        scene.mesh.triangles.push_back({first, first + 2, first + 3});
    };
    for (const double side : {-1.0, 1.0})
        for (int strip = 0; strip < 7; ++strip)
            for (const double behind : {1.0, 1.0005, 1.001}) {
                const double z = side * behind * std::pow(10, strip);
                add_square(z * Eigen::Vector3d((10 + 45 * strip - k.cx) / k.fx, -0.5, 1),
                           z * Eigen::Vector3d(40 / k.fx, 0, 0), z * Eigen::Vector3d(0, 1, 0));
            }
    for (PhotoInput& photo : scene.photos) photo.camera.cam_from_world = {};
    prepare(scene, {}, dir / "a.vantage", [](const Progress&) {});
    const PackageReader package(dir / "a.vantage");
    Renderer renderer(package, {});
    const std::vector<std::uint32_t> photos{0, 1};
    const View view = view_of_photo(package.photos()[0], 1);
    const Picture picture = take_picture(renderer, view, {}, photos, 1);
    const auto shown = renderer.triangles();
    const Rays rays(package.records<Eigen::Vector3f>(package::Type::positions),
                    package.records<std::uint32_t>(package::Type::indices));
    const Eigen::Vector3d eye = view.cam_from_origin.center();
    std::size_t seen = 0, colored = 0;
    for (int y = 0; y < k.height; y += 3)
        for (int x = 0; x < k.width; x += 3) {
            const Eigen::Vector3d ray = ray_of(k, view.cam_from_origin, x + 0.5, y + 0.5);
            const double z = rays.first(eye, ray);
            const std::size_t at = std::size_t(y) * std::size_t(k.width) + std::size_t(x);
            if (!std::isfinite(z)) continue;
            ++seen;
            ASSERT_GT(shown[at], 0u) << "at " << x << "," << y << " depth " << z;
            ASSERT_NEAR(rays.at(shown[at] - 1, eye, ray), z, 1e-5 * z) << "at " << x << "," << y;
            colored += picture.rgba[4 * at + 3] == 255;
        }
    EXPECT_GT(seen, 4000u);
    EXPECT_GT(double(colored), 0.99 * double(seen));
}
