#include "player/coordinate_slots.h"

#include <algorithm>

#include "scene/error.h"

namespace vantage {
namespace {
constexpr std::size_t budget_bytes = std::size_t(96) << 20;
}

CoordinateSlots::CoordinateSlots(std::uint32_t vertex_count, std::uint32_t photos, std::uint32_t least)
    : vertex_count_(vertex_count) {
    const std::size_t slot_bytes = std::max<std::size_t>(1, vertex_count) * 8;
    const std::size_t count =
        std::min<std::size_t>(photos, std::max<std::size_t>(budget_bytes / slot_bytes, least));
    slots_.resize(std::max<std::size_t>(1, count));
    buffer_ =
        gl::make_buffer("texture coordinates", slots_.size() * slot_bytes, nullptr, GL_DYNAMIC_STORAGE_BIT);
}

std::vector<std::uint32_t> CoordinateSlots::require(const PackageReader& package,
                                                    const std::vector<std::uint32_t>& photos) {
    ++request_;
    // Those that stay are marked first, so that none of them gives way to another of the same pass.
    for (Slot& s : slots_)
        if (s.photo && std::find(photos.begin(), photos.end(), *s.photo) != photos.end()) s.used = request_;
    std::vector<std::uint32_t> out;
    for (const std::uint32_t photo : photos) out.push_back(slot_for(package, photo));
    return out;
}

std::uint32_t CoordinateSlots::slot_for(const PackageReader& package, std::uint32_t photo) {
    auto slot = std::find_if(slots_.begin(), slots_.end(), [&](const Slot& s) { return s.photo == photo; });
    if (slot == slots_.end()) {
        slot = std::min_element(slots_.begin(), slots_.end(),
                                [](const Slot& a, const Slot& b) { return a.used < b.used; });
        const auto coordinates = package.records<float>(package::Type::coordinates, photo);
        if (coordinates.size() != std::size_t(2) * vertex_count_)
            throw Error(Exit::damaged, package.path().string() + ": TEXC of photo " + std::to_string(photo) +
                                           ": wrong length");
        const auto index = std::size_t(slot - slots_.begin());
        glNamedBufferSubData(buffer_.id(), GLintptr(index * 8 * vertex_count_),
                             GLsizeiptr(coordinates.size_bytes()), coordinates.data());
        slot->photo = photo;
    }
    slot->used = request_;
    return std::uint32_t(slot - slots_.begin());
}

}  // namespace vantage
