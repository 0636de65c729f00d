#include "tests/faults/disk_log.h"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace vantage {
namespace {

namespace fs = std::filesystem;
using Kind = DiskOperation::Kind;

constexpr std::size_t page = 4096;

std::string content_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// A file's content, independent of its name: the flushed content and the pending operations.
struct Inode {
    std::string flushed;
    std::vector<const DiskOperation*> pending;
};

void write_at(std::string& content, std::uint64_t offset, std::string_view data) {
    content.resize(std::max<std::size_t>(content.size(), offset + data.size()));
    std::ranges::copy(data, content.begin() + std::ptrdiff_t(offset));
}

void apply(const DiskOperation& o, std::string& content) {
    if (o.kind == Kind::size)
        content.resize(o.offset);
    else
        write_at(content, o.offset, o.data);
}

/// Applies only some pages of a write.
void apply_torn(const DiskOperation& o, std::string& content, std::mt19937& random) {
    if (o.kind == Kind::size) return;
    for (std::size_t at = 0; at < o.data.size();) {
        const std::size_t end = std::min<std::size_t>(o.data.size(), at + page - (o.offset + at) % page);
        if (random() % 2) write_at(content, o.offset + at, std::string_view(o.data).substr(at, end - at));
        at = end;
    }
}

class Disk {
  public:
    explicit Disk(const Files& before) {
        for (const auto& [path, content] : before) {
            names_[path] = inodes_.size();
            inodes_.push_back({content, {}});
        }
        flushed_names_ = names_;
    }
    void perform(const DiskOperation& o) {
        switch (o.kind) {
            case Kind::create:
                create(o.path);
                break;
            case Kind::write:
            case Kind::size:
                if (!names_.contains(o.path)) create(o.path);
                inodes_[names_.at(o.path)].pending.push_back(&o);
                break;
            case Kind::flush:
                flush(o.path);
                break;
            case Kind::rename:
                change({o.other, names_.at(o.path)});
                change({o.path, nothing});
                break;
            case Kind::remove:
                change({o.path, nothing});
                break;
        }
    }
    Files after_power_cut(std::mt19937& random) const {
        Names names = flushed_names_;
        std::size_t kept = random() % (pending_names_.size() + 1);
        // A rename consists of two entries, which take effect together.
        if (kept > 0 && kept < pending_names_.size() && pending_names_[kept].inode == nothing &&
            pending_names_[kept - 1].inode != nothing)
            ++kept;
        for (std::size_t i = 0; i < kept; ++i) apply_name(pending_names_[i], names);
        Files out;
        for (const auto& [path, inode] : names) out[path] = content(inodes_[inode], random);
        return out;
    }

  private:
    static constexpr std::size_t nothing = ~std::size_t(0);
    using Names = std::map<std::string, std::size_t>;  ///< inodes by path
    struct NameChange {
        std::string path;
        std::size_t inode;
    };

    void create(const std::string& path) {
        change({path, inodes_.size()});
        inodes_.emplace_back();
    }
    void change(const NameChange& c) {
        apply_name(c, names_);
        pending_names_.push_back(c);
    }
    static void apply_name(const NameChange& c, Names& names) {
        if (c.inode == nothing)
            names.erase(c.path);
        else
            names[c.path] = c.inode;
    }
    void flush(const std::string& path) {
        if (const auto file = names_.find(path); file != names_.end()) {
            Inode& inode = inodes_[file->second];
            for (const DiskOperation* o : inode.pending) apply(*o, inode.flushed);
            inode.pending.clear();
        } else {
            flushed_names_ = names_;
            pending_names_.clear();
        }
    }
    static std::string content(const Inode& inode, std::mt19937& random) {
        std::string out = inode.flushed;
        const unsigned mode = unsigned(random() % 4);  // none, all, the first ones, or any
        const std::size_t first = inode.pending.empty() ? 0 : random() % inode.pending.size();
        for (std::size_t i = 0; i < inode.pending.size(); ++i) {
            const unsigned chance = unsigned(random() % 3);
            if (mode == 1 || (mode == 2 && i < first) || (mode == 3 && chance == 0))
                apply(*inode.pending[i], out);
            else if (mode == 3 && chance == 1)
                apply_torn(*inode.pending[i], out, random);
        }
        return out;
    }

    std::vector<Inode> inodes_;
    Names names_, flushed_names_;
    std::vector<NameChange> pending_names_;
};

}  // namespace

std::vector<DiskOperation> read_disk_log(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::vector<DiskOperation> out;
    std::uint64_t n[5];
    while (in.read(reinterpret_cast<char*>(n), sizeof n)) {
        DiskOperation o{Kind(n[0]), n[1], std::string(n[2], 0), std::string(n[3], 0), std::string(n[4], 0)};
        for (std::string* part : {&o.path, &o.other, &o.data})
            in.read(part->data(), std::streamsize(part->size()));
        out.push_back(std::move(o));
    }
    return out;
}

Files files_below(const fs::path& folder) {
    Files out;
    for (const auto& e : fs::recursive_directory_iterator(folder))
        if (e.is_regular_file()) out[e.path()] = content_of(e.path());
    return out;
}

void restore(const fs::path& folder, const Files& files) {
    fs::remove_all(folder);
    fs::create_directories(folder);
    for (const auto& [path, content] : files) {
        fs::create_directories(fs::path(path).parent_path());
        std::ofstream(path, std::ios::binary) << content;
    }
}

Files after_power_cut(const Files& before, std::span<const DiskOperation> operations, std::mt19937& random) {
    Disk disk(before);
    for (const DiskOperation& o : operations) disk.perform(o);
    return disk.after_power_cut(random);
}

}  // namespace vantage
