#include "tests/openxr/calls/layers.h"

#include <cmath>
#include <numbers>

#include "tests/openxr/calls/system.h"
#include "tests/openxr/graphics.h"

namespace test_runtime {
namespace {

using nlohmann::json;

/// A layer that is being checked: its session, and its name for messages.
struct Part {
    XrSession session;
    std::string name;

    void require(bool holds, XrResult error, const char* what) const {
        if (!holds) breach(error, name + ": " + what);
    }
};

json numbers_of(const XrRect2Di& rect) {
    return {rect.offset.x, rect.offset.y, rect.extent.width, rect.extent.height};
}
json numbers_of(const XrFovf& fov) { return {fov.angleLeft, fov.angleRight, fov.angleUp, fov.angleDown}; }
json numbers_of(const XrVector3f& v) { return {v.x, v.y, v.z}; }
json numbers_of(const XrQuaternionf& q) { return {q.x, q.y, q.z, q.w}; }

const char* space_name(const Space& space) {
    if (std::holds_alternative<ActionSpace>(space.of)) return "action";
    switch (std::get<ReferenceSpace>(space.of).type) {
        case XR_REFERENCE_SPACE_TYPE_VIEW:
            return "view";
        case XR_REFERENCE_SPACE_TYPE_LOCAL:
            return "local";
        default:
            return "stage";
    }
}

const char* checked_space(const Part& part, XrSpace handle) {
    const Space* const space = handles().spaces.find(handle);
    part.require(space && space->session == part.session, XR_ERROR_HANDLE_INVALID,
                 "the space is not a live space of this session");
    return space_name(*space);
}

void check_flags(const Part& part, XrCompositionLayerFlags flags) {
    constexpr XrCompositionLayerFlags known = XR_COMPOSITION_LAYER_CORRECT_CHROMATIC_ABERRATION_BIT |
                                              XR_COMPOSITION_LAYER_BLEND_TEXTURE_SOURCE_ALPHA_BIT |
                                              XR_COMPOSITION_LAYER_UNPREMULTIPLIED_ALPHA_BIT;
    part.require((flags & ~known) == 0, XR_ERROR_VALIDATION_FAILURE, "a flag is unknown");
}

bool contains(const XrSwapchainCreateInfo& image, const XrRect2Di& rect) {
    const int64_t right = int64_t(rect.offset.x) + rect.extent.width,
                  top = int64_t(rect.offset.y) + rect.extent.height;
    return rect.offset.x >= 0 && rect.offset.y >= 0 && rect.extent.width > 0 && rect.extent.height > 0 &&
           right <= image.width && top <= image.height;
}

json checked_image(const Part& part, const XrSwapchainSubImage& image, bool depth) {
    const Swapchain* const swapchain = handles().swapchains.find(image.swapchain);
    part.require(swapchain && swapchain->session == part.session, XR_ERROR_HANDLE_INVALID,
                 "the swapchain is not a live swapchain of this session");
    part.require(contains(swapchain->info, image.imageRect), XR_ERROR_SWAPCHAIN_RECT_INVALID,
                 "the image rectangle exceeds the swapchain, or is empty");
    part.require(image.imageArrayIndex < swapchain->info.arraySize, XR_ERROR_VALIDATION_FAILURE,
                 "the array index exceeds the swapchain's array size");
    part.require(is_depth(swapchain->info.format) == depth, XR_ERROR_VALIDATION_FAILURE,
                 "the swapchain has a color format where depth is expected, or vice versa");
    part.require(swapchain->released.has_value(), XR_ERROR_LAYER_INVALID,
                 "no image of the swapchain has been released");
    return {{"rect", numbers_of(image.imageRect)},
            {"array_index", image.imageArrayIndex},
            {"image", *swapchain->released},
            {"format", format_name(swapchain->info.format)}};
}

void check_fov(const Part& part, const XrFovf& fov) {
    for (const float angle : {fov.angleLeft, fov.angleRight, fov.angleUp, fov.angleDown})
        part.require(std::isfinite(angle) && std::abs(angle) < std::numbers::pi_v<float> / 2,
                     XR_ERROR_VALIDATION_FAILURE,
                     "an angle of the field of view is not between -90 and 90 degrees");
    part.require(fov.angleLeft < fov.angleRight && fov.angleDown < fov.angleUp, XR_ERROR_VALIDATION_FAILURE,
                 "the field of view is empty or mirrored");
}

json checked_depth(const Part& part, const XrCompositionLayerDepthInfoKHR& info) {
    part.require(has_extension(part.session, XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME),
                 XR_ERROR_VALIDATION_FAILURE, "XR_KHR_composition_layer_depth is not enabled");
    const bool in_range = info.minDepth >= 0 && info.minDepth < info.maxDepth && info.maxDepth <= 1;
    part.require(in_range, XR_ERROR_VALIDATION_FAILURE, "the depth range is empty or extends beyond 0 to 1");
    part.require(info.nearZ != info.farZ && info.nearZ >= 0 && info.farZ >= 0, XR_ERROR_VALIDATION_FAILURE,
                 "the near and far distances are equal, or one of them is negative or not a number");
    json out = checked_image({part.session, part.name + " depth"}, info.subImage, true);
    out["min"] = info.minDepth;
    out["max"] = info.maxDepth;
    // JSON cannot represent infinity.
    out["near"] = std::isfinite(info.nearZ) ? json(info.nearZ) : json("infinite");
    out["far"] = std::isfinite(info.farZ) ? json(info.farZ) : json("infinite");
    return out;
}

json checked_view(const Part& part, const XrCompositionLayerProjectionView& view, SubmittedView& submitted) {
    check_struct(&view, XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW,
                 {XR_TYPE_COMPOSITION_LAYER_DEPTH_INFO_KHR});
    part.require(is_valid(view.pose), XR_ERROR_POSE_INVALID, "the pose is not valid");
    check_fov(part, view.fov);
    json out = checked_image(part, view.subImage, false);
    out["position"] = numbers_of(view.pose.position);
    out["orientation"] = numbers_of(view.pose.orientation);
    out["fov"] = numbers_of(view.fov);
    out["depth"] = nullptr;
    submitted = {view.subImage, {}};
    if (const void* next = next_of_type(view.next, XR_TYPE_COMPOSITION_LAYER_DEPTH_INFO_KHR)) {
        const auto& depth = *static_cast<const XrCompositionLayerDepthInfoKHR*>(next);
        out["depth"] = checked_depth(part, depth);
        submitted.depth = depth.subImage;
    }
    return out;
}

json checked_projection(const Part& part, const XrCompositionLayerProjection& layer,
                        std::vector<SubmittedView>& views) {
    check_struct(&layer, XR_TYPE_COMPOSITION_LAYER_PROJECTION);
    check_flags(part, layer.layerFlags);
    json out = {
        {"type", "projection"}, {"space", checked_space(part, layer.space)}, {"flags", layer.layerFlags}};
    part.require(layer.viewCount == 2 && layer.views, XR_ERROR_VALIDATION_FAILURE,
                 "the number of views is not two");
    views.resize(layer.viewCount);
    for (uint32_t i = 0; i < layer.viewCount; ++i)
        out["views"].push_back(
            checked_view({part.session, part.name + " view " + std::to_string(i)}, layer.views[i], views[i]));
    return out;
}

json checked_quad(const Part& part, const XrCompositionLayerQuad& layer) {
    check_struct(&layer, XR_TYPE_COMPOSITION_LAYER_QUAD);
    check_flags(part, layer.layerFlags);
    part.require(layer.eyeVisibility <= XR_EYE_VISIBILITY_RIGHT, XR_ERROR_VALIDATION_FAILURE,
                 "the eye visibility is unknown");
    part.require(is_valid(layer.pose), XR_ERROR_POSE_INVALID, "the pose is not valid");
    part.require(layer.size.width > 0 && layer.size.height > 0, XR_ERROR_VALIDATION_FAILURE,
                 "its size is not positive");
    json out = checked_image(part, layer.subImage, false);
    out["type"] = "quad";
    out["space"] = checked_space(part, layer.space);
    out["flags"] = layer.layerFlags;
    out["position"] = numbers_of(layer.pose.position);
    out["orientation"] = numbers_of(layer.pose.orientation);
    out["size"] = {layer.size.width, layer.size.height};
    return out;
}

json checked_layer(const Part& part, const XrCompositionLayerBaseHeader* layer,
                   std::vector<SubmittedView>& views) {
    part.require(layer, XR_ERROR_LAYER_INVALID, "it is missing");
    if (layer->type == XR_TYPE_COMPOSITION_LAYER_PROJECTION)
        return checked_projection(part, *reinterpret_cast<const XrCompositionLayerProjection*>(layer), views);
    part.require(layer->type == XR_TYPE_COMPOSITION_LAYER_QUAD, XR_ERROR_LAYER_INVALID,
                 "it is neither a projection nor a quad");
    return checked_quad(part, *reinterpret_cast<const XrCompositionLayerQuad*>(layer));
}

}  // namespace

SubmittedLayers checked_layers(XrSession session, const XrFrameEndInfo& info) {
    require(info.layerCount <= max_layers, XR_ERROR_LAYER_LIMIT_EXCEEDED, "there are too many layers");
    require(info.layerCount == 0 || info.layers, XR_ERROR_VALIDATION_FAILURE, "the layers are missing");
    SubmittedLayers out;
    for (uint32_t i = 0; i < info.layerCount; ++i) {
        std::vector<SubmittedView> views;
        out.record.push_back(checked_layer({session, "layer " + std::to_string(i)}, info.layers[i], views));
        if (out.views.empty()) out.views = views;
    }
    return out;
}

}  // namespace test_runtime
