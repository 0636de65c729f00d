#pragma once
#include "jpeg.h"

// Decoders for forms 2 to 5. They return the texels of an area, four bytes each.
namespace independent {

Buffer decode_jpeg_block(Bytes shared, Bytes block, Area area);

// Decodes a tile of a chunk in one of the forms 2 to 5. `area`: the area of the tile in its level.
Buffer decode_area(const Entry& entry, const Chunk& chunk, Size level, uint64_t tile, Area area);

}  // namespace independent
