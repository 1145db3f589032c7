#include "scene/mesh_files/ply/ply_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <span>
#include <utility>

#include "scene/imported_mesh.h"
#include "scene/mesh_files/text/word_reader.h"

namespace rayscope::scene {

namespace {

struct RoleName {
    std::string_view name;
    PlyRole role;
};
/// The names that MeshLab, Blender, assimp and three.js write or read.
constexpr std::array kVertexNames{
    RoleName{"x", PlyRole::X},         RoleName{"px", PlyRole::X},
    RoleName{"posx", PlyRole::X},      RoleName{"y", PlyRole::Y},
    RoleName{"py", PlyRole::Y},        RoleName{"posy", PlyRole::Y},
    RoleName{"z", PlyRole::Z},         RoleName{"pz", PlyRole::Z},
    RoleName{"posz", PlyRole::Z},      RoleName{"nx", PlyRole::Nx},
    RoleName{"normalx", PlyRole::Nx},  RoleName{"ny", PlyRole::Ny},
    RoleName{"normaly", PlyRole::Ny},  RoleName{"nz", PlyRole::Nz},
    RoleName{"normalz", PlyRole::Nz},  RoleName{"s", PlyRole::U},
    RoleName{"u", PlyRole::U},         RoleName{"texture_u", PlyRole::U},
    RoleName{"texture_s", PlyRole::U}, RoleName{"tx", PlyRole::U},
    RoleName{"t", PlyRole::V},         RoleName{"v", PlyRole::V},
    RoleName{"texture_v", PlyRole::V}, RoleName{"texture_t", PlyRole::V},
    RoleName{"ty", PlyRole::V},        RoleName{"red", PlyRole::R},
    RoleName{"r", PlyRole::R},         RoleName{"diffuse_red", PlyRole::R},
    RoleName{"diffuse_r", PlyRole::R}, RoleName{"green", PlyRole::G},
    RoleName{"g", PlyRole::G},         RoleName{"diffuse_green", PlyRole::G},
    RoleName{"diffuse_g", PlyRole::G}, RoleName{"blue", PlyRole::B},
    RoleName{"b", PlyRole::B},         RoleName{"diffuse_blue", PlyRole::B},
    RoleName{"diffuse_b", PlyRole::B},
};
constexpr std::array kFaceNames{
    RoleName{"vertex_indices", PlyRole::Indices}, RoleName{"vertex_index", PlyRole::Indices},
    RoleName{"texcoord", PlyRole::TexCoords}, RoleName{"texnumber", PlyRole::TexNumber}};
constexpr std::array kStripNames{RoleName{"vertex_indices", PlyRole::Indices},
                                 RoleName{"vertex_index", PlyRole::Indices}};

/// The names, shortened if there are many.
std::string listed(const std::set<std::string>& names) {
    constexpr std::size_t kMost = 8;
    const std::size_t shownNames = std::min(names.size(), kMost);
    std::string text = fmt::format(
        "{}",
        fmt::join(names.begin(), std::next(names.begin(), static_cast<std::ptrdiff_t>(shownNames)), ", "));
    if (names.size() > kMost) text += fmt::format(" and {} more", names.size() - kMost);
    return text;
}

bool isListRole(PlyRole role) { return role == PlyRole::Indices || role == PlyRole::TexCoords; }

class Planner {
  public:
    Planner(const std::string& path, PlyHeader header, bool withColors, Oddities& oddities)
        : path_(path), withColors_(withColors), oddities_(oddities) {
        plan_.header = std::move(header);
    }

    PlyPlan plan() {
        plan_.vertices = plan_.header.find("vertex");
        plan_.faces = plan_.header.find("face");
        plan_.strips = plan_.header.find("tristrips");
        for (const PlyElement& element : plan_.header.elements)
            plan_.roles.emplace_back(element.properties.size(), PlyRole::Ignored);
        checkElements();
        assignRoles(plan_.vertices, kVertexNames);
        planVertices();
        planFaces();
        reportIgnored();
        return std::move(plan_);
    }

  private:
    std::size_t elements() const { return plan_.header.elements.size(); }

    void checkElements() const {
        const std::uint64_t points = plan_.vertexCount();
        if (plan_.vertices == elements()) throw InputError("the header has no element 'vertex'", {path_});
        if (plan_.countOf(plan_.faces) + plan_.countOf(plan_.strips) == 0)
            throw InputError(
                points == 0
                    ? "the file has no faces"
                    : fmt::format("the file has {} points but no faces; make a mesh of them first", points),
                {path_});
        if (points > std::numeric_limits<std::int32_t>::max())
            throw InputError(fmt::format("{} vertices are more than 2147483647", points),
                             {path_, plan_.header.elements[plan_.vertices].line});
    }

    void assignRoles(std::size_t element, std::span<const RoleName> names) {
        if (element == elements()) return;
        const std::vector<PlyProperty>& properties = plan_.header.elements[element].properties;
        for (std::size_t i = 0; i < properties.size(); ++i) {
            const auto found = std::find_if(names.begin(), names.end(),
                                            [&](const RoleName& n) { return n.name == properties[i].name; });
            if (found == names.end() || isListRole(found->role) != properties[i].countType.has_value())
                continue;
            if (has(element, found->role))
                oddities_.add(Severity::Warning,
                              fmt::format("a second property for the same purpose, '{}'; the first is used",
                                          properties[i].name),
                              properties[i].line);
            else
                plan_.roles[element][i] = found->role;
        }
    }

    /// The index of the property with a role.
    std::optional<std::size_t> propertyOf(std::size_t element, PlyRole role) const {
        const auto& roles = plan_.roles[element];
        const auto found = std::find(roles.begin(), roles.end(), role);
        if (found == roles.end()) return {};
        return static_cast<std::size_t>(found - roles.begin());
    }
    bool has(std::size_t element, PlyRole role) const { return propertyOf(element, role).has_value(); }

    /// Whether an attribute is complete; an incomplete one is reported and ignored.
    bool completes(std::span<const PlyRole> attribute, std::string_view what) {
        const auto present = static_cast<std::size_t>(std::count_if(
            attribute.begin(), attribute.end(), [&](PlyRole role) { return has(plan_.vertices, role); }));
        if (present == attribute.size()) return true;
        if (present > 0)
            oddities_.add(Severity::Warning,
                          fmt::format("{} with fewer than {} components; ignored", what, attribute.size()),
                          plan_.header.elements[plan_.vertices].line);
        ignore(attribute);
        return false;
    }
    void ignore(std::span<const PlyRole> attribute) {
        for (PlyRole& role : plan_.roles[plan_.vertices])
            if (std::find(attribute.begin(), attribute.end(), role) != attribute.end())
                role = PlyRole::Ignored;
    }

    void planVertices() {
        const PlyElement& element = plan_.header.elements[plan_.vertices];
        for (const auto& [role, name] : {std::pair(PlyRole::X, 'x'), {PlyRole::Y, 'y'}, {PlyRole::Z, 'z'}})
            if (!has(plan_.vertices, role))
                throw InputError(fmt::format("the element 'vertex' has no property '{}'", name),
                                 {path_, element.line});
        plan_.hasNormals = completes(std::array{PlyRole::Nx, PlyRole::Ny, PlyRole::Nz}, "normals");
        plan_.hasTexCoords = completes(std::array{PlyRole::U, PlyRole::V}, "texture coordinates");
        constexpr std::array kColor{PlyRole::R, PlyRole::G, PlyRole::B};
        plan_.hasColors = completes(kColor, "vertex colours");
        if (!plan_.hasColors) return;
        for (std::size_t i = 0; i < kColor.size(); ++i)
            plan_.hasColors &= setLargestColor(element.properties[*propertyOf(plan_.vertices, kColor[i])], i);
        if (plan_.hasColors && !withColors_) {
            oddities_.add(Severity::Note, kColorsNotShown,
                          element.properties[*propertyOf(plan_.vertices, PlyRole::R)].line);
            colorsNotShown_ = true;
            plan_.hasColors = false;
        }
        if (!plan_.hasColors) ignore(kColor);
    }

    bool setLargestColor(const PlyProperty& property, std::size_t channel) {
        float& largest = plan_.largestColor[channel];
        if (property.type == PlyType::UInt8) return largest = 255.0f, true;
        if (property.type == PlyType::UInt16) return largest = 65535.0f, true;
        if (!isInteger(property.type)) return largest = 1.0f, true;
        oddities_.add(
            Severity::Warning,
            "vertex colours of a type without a usual range (expected uchar, ushort or float); ignored",
            property.line);
        return false;
    }

    void planFaces() {
        assignRoles(plan_.faces, kFaceNames);
        assignRoles(plan_.strips, kStripNames);
        for (const std::size_t element : {plan_.faces, plan_.strips})
            if (plan_.countOf(element) > 0 && !has(element, PlyRole::Indices))
                throw InputError(
                    fmt::format("the element '{}' has no list 'vertex_indices' or 'vertex_index'",
                                plan_.header.elements[element].name),
                    {path_, plan_.header.elements[element].line});
        if (plan_.faces == elements()) return;
        plan_.hasCornerTexCoords = has(plan_.faces, PlyRole::TexCoords);
        plan_.hasTextureNumbers =
            has(plan_.faces, PlyRole::TexNumber) && plan_.header.textureFiles.size() > 1;
    }

    void reportIgnored() {
        std::set<std::string> properties, elementNames;
        for (std::size_t e = 0; e < elements(); ++e) {
            const PlyElement& element = plan_.header.elements[e];
            const bool isRead = e == plan_.vertices || e == plan_.faces || e == plan_.strips;
            if (!isRead && element.count > 0) elementNames.insert(shown(element.name));
            if (!isRead) continue;
            for (std::size_t i = 0; i < element.properties.size(); ++i)
                if (plan_.roles[e][i] == PlyRole::Ignored && !isReported(e, element.properties[i].name))
                    properties.insert(
                        fmt::format("{} of {}", shown(element.properties[i].name), element.name));
        }
        if (!elementNames.empty())
            oddities_.add(Severity::Note, fmt::format("ignored elements: {}", listed(elementNames)));
        if (!properties.empty())
            oddities_.add(Severity::Note, fmt::format("ignored properties: {}", listed(properties)));
    }

    /// Whether a property without a role is a colour that is reported already, or its alpha channel.
    bool isReported(std::size_t element, std::string_view name) const {
        if (element != plan_.vertices || !colorsNotShown_) return false;
        const auto isColor = [&](const RoleName& known) {
            return known.name == name && known.role >= PlyRole::R && known.role <= PlyRole::B;
        };
        return std::any_of(kVertexNames.begin(), kVertexNames.end(), isColor);
    }

    const std::string& path_;
    bool withColors_;
    Oddities& oddities_;
    PlyPlan plan_{};
    bool colorsNotShown_ = false;
};

}  // namespace

PlyPlan planPly(const std::string& path, PlyHeader header, bool withColors, Oddities& oddities) {
    return Planner(path, std::move(header), withColors, oddities).plan();
}

}  // namespace rayscope::scene
