#!/usr/bin/env python3
"""Opens a package over a slow network: nginx behind a proxy that delays, throttles and cuts connections.

    tests/bench/remote.py PACKAGE [--photo NAME]

For each network, prints the time to the window's first picture (under Xvfb). For a photo's view at 1280x720, also prints the
times until the window has all the tiles it wants and until an exact picture is rendered (4 photos blended), each with the
number of megabytes that the server sent. Then prints the same values for a second visit, when the data is in the cache.
Requires nginx and Xvfb.
"""
import argparse, asyncio, os, random, subprocess, sys, tempfile, threading, time

NETWORKS = [("50 ms, 20 Mbit/s", 0.05, 20e6, 0), ("200 ms, 2 Mbit/s", 0.2, 2e6, 0),
            ("50 ms, 20 Mbit/s, 1 % of connections cut", 0.05, 20e6, 0.01),
            ("50 ms, 20 Mbit/s, 20 % of connections cut", 0.05, 20e6, 0.2)]
PLAYER = os.path.join(os.path.dirname(__file__), "../../build/player/vantage-player")


class Proxy:
    """Forwards connections to a port with a round-trip time of `rtt` seconds and a total bandwidth of `bits` per second.
    A fraction `cut` of the connections is closed after at most one megabyte."""

    def __init__(self, target, rtt, bits, cut):
        self.target, self.rtt, self.rate, self.cut = target, rtt, bits / 8, cut
        self.free_at = self.sent = 0
        self.random = random.Random(1)
        self.loop = asyncio.new_event_loop()
        started = threading.Event()
        threading.Thread(target=self.run, args=(started,), daemon=True).start()
        started.wait()

    def run(self, started):
        asyncio.set_event_loop(self.loop)
        server = self.loop.run_until_complete(asyncio.start_server(self.serve, "127.0.0.1", 0))
        self.port = server.sockets[0].getsockname()[1]
        started.set()
        self.loop.run_forever()

    async def serve(self, reader, writer):
        await asyncio.sleep(self.rtt)  # the handshake
        from_server, to_server = await asyncio.open_connection("127.0.0.1", self.target)
        left = self.random.randint(1, 1 << 20) if self.random.random() < self.cut else None
        await asyncio.gather(self.forward(reader, to_server, False, None), self.forward(from_server, writer, True, left))

    async def forward(self, reader, writer, limited, left):
        queue = asyncio.Queue(64)
        task = asyncio.ensure_future(self.deliver(queue, writer))
        try:
            while data := await reader.read(16384):
                if left is not None:
                    data = data[:left]
                    left -= len(data)
                if limited:
                    self.free_at = max(self.free_at, time.monotonic()) + len(data) / self.rate
                    self.sent += len(data)
                    await asyncio.sleep(self.free_at - time.monotonic())
                await queue.put((time.monotonic() + self.rtt / 2, data))
                if left == 0:
                    break
        except OSError:
            pass
        await queue.put((0, b""))
        await task

    async def deliver(self, queue, writer):
        try:
            while (item := await queue.get())[1]:
                await asyncio.sleep(item[0] - time.monotonic())
                writer.write(item[1])
                await writer.drain()
        except OSError:
            pass
        writer.close()


def start_nginx(folder, package):
    os.makedirs(f"{folder}/served")
    os.symlink(os.path.abspath(package), f"{folder}/served/scan.vantage")
    port = 20000 + os.getpid() % 10000
    temporary = "".join(f"{n}_temp_path {folder}/{n};" for n in ("client_body", "proxy", "fastcgi", "uwsgi", "scgi"))
    with open(f"{folder}/nginx.conf", "w") as conf:
        conf.write(f"daemon off; master_process off; pid {folder}/pid; error_log {folder}/log; events {{}} http {{ access_log off; {temporary}"
                   f" keepalive_requests 100000; server {{ listen 127.0.0.1:{port}; root {folder}/served; }} }}")
    server = subprocess.Popen(["/usr/sbin/nginx", "-e", f"{folder}/log", "-c", f"{folder}/nginx.conf"])
    time.sleep(0.5)
    return server, port


def run(arguments, cache, before=()):
    start = time.monotonic()
    done = subprocess.run([*before, PLAYER, *arguments], env={**os.environ, "XDG_CACHE_HOME": cache}, capture_output=True, text=True)
    if done.returncode:
        sys.exit(done.stderr)
    return time.monotonic() - start, done.stderr


def first_picture(package, cache):
    """The time in seconds until the window shows a picture."""
    words = run([package, "--no-saved-settings", "--size", "1280x720", "--frames", "1"], cache, ["xvfb-run", "-a"])[1]
    return float(words.split("first picture after ")[1].split()[0]) / 1000


def sharp_in_the_window(package, photo, folder, cache):
    """The time in seconds until the window has all the tiles that it wants, including the start of the program."""
    return run(["bench", package, "--photo", photo, "--paths", "still", "--modes", "stream", "--repeats", "1", "--path-frames", "5000",
                "--until-exact", "--size", "1280x720", "-o", f"{folder}/bench", "--force"], cache)[0]


def exact_picture(package, photo, folder, cache):
    """The time in seconds to render a picture without skipped tiles."""
    return run(["render", package, "--photo", photo, "--size", "1280x720", "--samples", "1", "--max-photos", "4",
                "-o", f"{folder}/picture.png"], cache)[0]


def visit(url, proxy, folder, cache, photo):
    """Table cells with the seconds and the bytes sent by the server, for three measurements with separate caches."""
    cells = [f"{first_picture(url, f'{cache}-first'):.1f} s"]
    for picture in (sharp_in_the_window, exact_picture):
        before = proxy.sent
        cells += [f"{picture(url, photo, folder, f'{cache}-{picture.__name__}'):.1f} s", f"{(proxy.sent - before) / 1e6:.3f}"]
    return " | ".join(cells)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("package")
    parser.add_argument("--photo")
    o = parser.parse_args()
    photo = o.photo or subprocess.run([PLAYER, "list", o.package], capture_output=True, text=True).stdout.split()[0]
    with tempfile.TemporaryDirectory() as folder:
        server, port = start_nginx(folder, o.package)
        print("| network | visit | first picture | sharp | MB sent | exact | MB sent |\n|---|---|---|---|---|---|---|")
        print(f"| file | | | {sharp_in_the_window(o.package, photo, folder, folder):.1f} s | "
              f"| {exact_picture(o.package, photo, folder, folder):.1f} s | |", flush=True)
        for i, (name, rtt, bits, cut) in enumerate(NETWORKS):
            proxy = Proxy(port, rtt, bits, cut)
            url = f"http://127.0.0.1:{proxy.port}/scan.vantage"
            for which in ("first", "second"):
                print(f"| {name} | {which} | {visit(url, proxy, folder, f'{folder}/cache{i}', photo)} |", flush=True)
        server.terminate()


main()
