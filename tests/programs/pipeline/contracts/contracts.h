#pragma once
#include <fstream>

#include "base/text/error.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/photos/photos.h"
#include "scene/package/package_reader.h"
#include "tests/one_line.h"
#include "tests/programs/overnight.h"
#include "tests/programs/patterns.h"

namespace vantage {

class Contracts : public Overnight {
  protected:
    const fs::path images = scene / "images", mesh = scene / "mesh.ply", sparse = scene / "sparse";

    static void write(const fs::path& to, const std::string& bytes) {
        std::ofstream(to, std::ios::binary) << bytes;
    }
    /// Expects a one-line refusal before any work is done, with the file `kept` left unchanged.
    void expect_refused(const std::string& words, const fs::path& kept,
                        const std::string& program = VANTAGE_PROGRAM) const {
        const std::string before = slurp(kept);
        const Outcome o = run(words, "", program);
        EXPECT_EQ(o.code, int(Exit::usage)) << words << '\n' << o.out << o.err;
        EXPECT_TRUE(one_line(o.err)) << words << '\n' << o.err;
        EXPECT_EQ(o.out, "") << words;
        EXPECT_TRUE(slurp(kept) == before) << words << ": " << kept;
    }
    std::string prepare_to(const fs::path& out) const {
        return "prepare --progress none " + scene.string() + " -o " + out.string() + " ";
    }
    Outcome player(const std::string& words) const { return run(words, "", VANTAGE_PLAYER); }
    std::string package() const { return file.string(); }

    /// Overwrites bytes of a chunk without changing the file's size.
    void damage(package::Type type, std::uint32_t photo = package::scene_wide, std::uint64_t at = 20) const {
        {
            const PackageReader reader(file);
            const auto* e = reader.find(type, photo);
            at += e->offset + (e->block_length || e->coded_blocks ? e->head_length : 0);
        }
        std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
        bytes.seekp(std::streamoff(at));
        bytes << "rot";
    }
    void expect_damage_found(std::initializer_list<package::Type> types);
    /// Turns the second photo into a PNG that has the same name as the first photo, except for the extension.
    void share_a_stem() const {
        const std::string jpeg = slurp(images / "0001.jpg");
        const RgbaImage image = read_photo(images / "0001.jpg", read_photo_header(images / "0001.jpg").size);
        image_files().write(images / "0000.png", image.width, image.height, 4, Sample::u8,
                            std::as_bytes(std::span(image.rgba)));
        fs::remove(images / "0001.jpg");
        write(sparse / "images.txt", replaced(slurp(sparse / "images.txt"), "0001\\.jpg", "0000.png"));
    }
};
class ContractsAtLength : public Contracts {};

}  // namespace vantage
