"""Makes the files that documented commands read: small scenes and packages, each of which is made once and then copied."""
import functools
import http.server
import re
import shutil
import subprocess

from code_blocks import block_after, comment_after

# The building is two units wide, so that orthophotos at the documented resolutions are small. The photos are
# numbered 0000 to 0007.
SMALL = '''
scene = {seed = 3}
building = {bays = 3, floors = 2, width = 2.0, height = 1.5, depth = 1.0, recess = 0.15}
object = {triangles = 6000, size = 0.3, distance = 0.8}
photos = {count = 8, width = 331, height = 250, fov = 60, radius = 2.5, low = 0.5, high = 1.4, arc = 80, samples = 3}
'''


class Inputs:
    """Makes inputs by name, using the programs in FOLDER/bin."""

    def __init__(self, folder, source, environment, at_length):
        self.bin, self.made, self.source, self.environment = folder / 'bin', folder / 'made', source, environment
        self.made.mkdir()
        scan, package = self.copy(self.scan), self.copy(self.package)
        self.makers = {
            'scans/chapel': scan, 'scans/altar': scan, 'chapel': scan,
            'chapel.vantage': package, 'altar.vantage': package, 'demo.vantage': package, 'collection/chapel.vantage': package,
            'collection/*.vantage': self.two(package, '.vantage'), 'scans': self.two(scan), 'golden': self.two(self.copy(self.golden)),
            'new.vantage': self.copy(self.other_package),
            'chapel-2019.ply': self.copy(lambda: self.scan() / 'mesh.ply'), 'scanner.ply': self.points, 'scans/quarry': self.quarry,
            'panel': self.panel, 'image_sets.toml': self.image_sets, 'chapel-0001.path': self.path, 'walk.path': self.path,
            'church.toml': self.church, 'chapel.toml': self.chapel}
        self.of_page = {'docs/story.md': {'chapel.vantage': self.copy(lambda: self.package('tiny.toml'))}}  # the note is on this one
        if at_length:  # this one has enough features for align, and is generated in half a minute
            self.of_page['docs/cameras.md'] = {'scans/chapel': self.copy(lambda: self.scan('small.toml'))}
        self.beside = {'docs/story.md': self.story, 'docs/video.md': self.quick_story}  # chapel.story.json, which no command names

    def need(self, to, name, page=None):
        """Makes the input with that name, unless it exists."""
        make = self.of_page.get(page, {}).get(name) or self.makers.get(name)
        if make and (not to.exists() or name in ('scans', 'golden')):
            to.parent.mkdir(parents=True, exist_ok=True)
            make(to)

    def run(self, program, *arguments):
        subprocess.run([self.bin / program, *arguments, '-q'], check=True, env=self.environment, cwd=self.made)

    def copy(self, original):
        def make(to):
            (shutil.copytree if original().is_dir() else shutil.copy2)(original(), to)
        return make

    def two(self, make, extension=''):
        """Makes two folders named chapel and altar or, with an extension, two such files. `to` is their folder or,
        with an extension, a pattern of files in it."""
        def make_two(to):
            folder = to.parent if extension else to
            folder.mkdir(exist_ok=True)
            for file in (folder / (name + extension) for name in ('chapel', 'altar')):
                if not file.exists():
                    make(file)
        return make_two

    @functools.lru_cache(None)
    def scan(self, spec=None):
        """A small scan from the specification `spec` in data/, or from SMALL. Its mesh has a scalar field named deviation."""
        out = self.made / f'scan of {spec}'
        (self.made / 'scan.toml').write_text((self.source / 'data' / spec).read_text() if spec else SMALL)
        self.run('vantage', 'synth', 'scan.toml', '-o', out)
        shutil.rmtree(out / 'truth')
        head, body = self.mesh(out)
        vertices, size = int(re.search(rb'element vertex (\d+)', head)[1]), 3 * 8 + 3 * 4  # a position and a normal
        rows = b''.join(body[i * size:(i + 1) * size] + body[(i + 1) * size - 12:(i + 1) * size - 8] for i in range(vertices))
        head = head.replace(b'element face', b'property float deviation\nelement face')
        (out / 'mesh.ply').write_bytes(head + b'end_header\n' + rows + body[vertices * size:])
        return out

    def mesh(self, scan):
        """The header and the body of the scan's mesh file."""
        return (scan / 'mesh.ply').read_bytes().split(b'end_header\n', 1)

    @functools.lru_cache(None)
    def package(self, spec=None):
        out = self.made / f'package of {spec}.vantage'
        self.run('vantage', 'prepare', self.scan(spec) if spec else self.scan(), '-o', out)  # scan(None) has its own cache entry
        return out

    @functools.lru_cache(None)
    def other_package(self):
        """A package of the same scene with a different decision on an effect."""
        self.run('vantage', 'refine', self.package(), '--effect', 'exposure=on', '-o', 'new.vantage')
        return self.made / 'new.vantage'

    @functools.lru_cache(None)
    def golden(self):
        out = self.made / 'golden'
        out.mkdir()
        self.path(out / 'views.path')
        self.run('vantage-player', 'verify', self.package(), '--golden', out, '--update')
        return out

    def points(self, to):
        """Writes the vertices of the mesh, without its faces."""
        head, body = self.mesh(self.scan())
        to.write_bytes(head[:head.index(b'element face')] + b'end_header\n' + body)

    def quarry(self, to):
        shutil.copytree(self.scan(), to)
        (to / 'mesh.ply').unlink()
        self.points(to / 'cloud.ply')

    def panel(self, to):
        """Makes photos with the names by which image_sets.toml groups them: NUMBER_vis.jpg and ir/NUMBER.jpg."""
        self.run('vantage', 'synth', self.source / 'data/image_sets.toml', '-o', to)
        shutil.rmtree(to / 'truth')
        for photo in (to / 'images/visible').iterdir():
            photo.rename(to / 'images' / f'{photo.stem}_vis.jpg')
        (to / 'images/visible').rmdir()
        (to / 'images/infrared').rename(to / 'images/ir')
        cameras = to / 'sparse/images.txt'
        cameras.write_text(re.sub(r'visible/(\d+)', r'\1_vis', cameras.read_text()).replace('infrared/', 'ir/'))

    def image_sets(self, to):
        """Writes the image_sets.toml shown in the comment after the command in docs/scenes.md."""
        to.write_text(comment_after(self.source / 'docs/scenes.md', '--image-sets image_sets.toml').replace('  and  ', '\n'))

    def church(self, to):
        to.write_text(block_after(self.source / 'docs/scenes.md', '# church.toml'))
        for name in re.findall(r'(?m)^input = "(.*?)"', to.read_text()):
            self.need(to.parent / name, name)

    def chapel(self, to):
        """Writes the scene file as align would write it; align itself runs only in the full set of tests."""
        self.need(to.parent / 'scans/chapel', 'scans/chapel')
        to.write_text('[[object]]\ninput = "scans/chapel"\n')

    def story(self, folder):
        (folder / 'chapel.story.json').write_text(block_after(self.source / 'docs/story.md', '{'))
        (folder / 'pictures').mkdir()
        shutil.copy(self.scan() / 'images/0000.jpg', folder / 'pictures/clock.jpg')

    def quick_story(self, folder):
        """Writes the same story, but with a tour of less than a second, for a video."""
        self.story(folder)
        told = folder / 'chapel.story.json'
        told.write_text(re.sub(r'"(fly|stay)": \d+', r'"\1": 0.1', told.read_text()))

    def path(self, to):
        to.write_text('4,-9,2,0,0,1,40 at=0\n3.9,-9,2,0,0,1,40 at=0.2\n')


def server(package):
    """A web server that returns a package for every path and supports range requests."""

    class Server(http.server.BaseHTTPRequestHandler):
        protocol_version = 'HTTP/1.1'

        def do_GET(self):
            content = package().read_bytes()
            asked = re.fullmatch(r'bytes=(\d+)-(\d*)', self.headers.get('Range', ''))
            first, last = (int(asked[1]), min(int(asked[2] or len(content)), len(content) - 1)) if asked else (0, len(content) - 1)
            self.send_response(206 if asked else 200)
            if asked:
                self.send_header('Content-Range', f'bytes {first}-{last}/{len(content)}')
            self.send_header('Content-Length', str(last - first + 1))
            self.send_header('ETag', '"1"')
            self.end_headers()
            self.wfile.write(content[first:last + 1])

        def log_message(self, *_):
            pass

    out = http.server.ThreadingHTTPServer(('127.0.0.1', 0), Server)
    out.handle_error = lambda *_: None  # players cancel requests
    return out
