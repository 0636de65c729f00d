#pragma once
#include "jpeg.h"

// Forms 2 to 5: each gives the texels of an area, four bytes each.
namespace independent {

Buffer decode_jpeg_block(Bytes shared, Bytes block, Area area);

// Of a chunk of form 2 to 5; `area`: that of the tile in its level.
Buffer decode_area(const Entry& entry, const Chunk& chunk, Size level, uint64_t tile, Area area);

}  // namespace independent
