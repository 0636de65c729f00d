#!/usr/bin/env python3
"""Makes a scene for outside_gain.py from a dataset, with one known disturbance.

    disturb.py DATASET KIND OUT --kit KIT

DATASET is a folder with images/, sparse/ (COLMAP text, PINHOLE) and mesh.ply. KIT is the folder of the measurement kit, whose
dataset.py is used. Photos are downscaled; all lengths in px refer to the downscaled photos. OUT/scan is the input for
`vantage prepare`; OUT/truth contains the reference photos and cameras. The same arguments always give the same files.

KIND:
  plain       The photos are only downscaled.
  cameras     Each camera is off by 1 to 3 px in a random direction, half by rotation and half by translation.
  slightly    Each camera is off by 0.5 to 1 px.
  camera      One camera is off by 4 px.
  exposure    The exposure of each photo is changed by up to 0.3 stops, and that of each channel by up to 0.1 stops.
  vignetting  All photos lose 35 % of the light in the corners, and so do the reference photos, because the player shows a
              photo with its own vignetting.
  strangers   Four photos each contain two textured figures, at different places.
  waves       The mesh is displaced along its normals by waves of 0.3 % of its size.
  smooth      The mesh is smoothed."""
import argparse
import os
import sys

import cv2
import numpy as np


def rotation(axis_angle):
    return cv2.Rodrigues(np.asarray(axis_angle, float))[0]


def quaternion(R):
    """The quaternion (w, x, y, z) of a rotation matrix."""
    axis_angle = cv2.Rodrigues(R)[0].ravel()
    angle = np.linalg.norm(axis_angle)
    axis = axis_angle / angle if angle > 0 else axis_angle
    return [np.cos(angle / 2), *(np.sin(angle / 2) * axis)]


def linear(photo):
    c = photo / 255.0
    return np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)


def encoded(light):
    c = np.where(light <= 0.0031308, 12.92 * light, 1.055 * np.maximum(light, 1e-9) ** (1 / 2.4) - 0.055)
    return np.clip(255 * c + 0.5, 0, 255).astype(np.uint8)


class Scene:
    """Photos by name, the kit's cameras, and a mesh, all in memory."""

    def __init__(self, data, mesh, long_side):
        self.photos, self.cameras, self.V, self.F = {}, data.cameras, mesh.V.copy(), mesh.F
        for name, c in self.cameras.items():
            scale = min(1, long_side / max(c.w, c.h))
            w, h = (4 * round(scale * n / 4) for n in (c.w, c.h))  # so that half the size is exact
            self.photos[name] = cv2.resize(data.photo(name), (w, h), interpolation=cv2.INTER_AREA)
            c.fx, c.cx, c.fy, c.cy, c.w, c.h = c.fx * w / c.w, c.cx * w / c.w, c.fy * h / c.h, c.cy * h / c.h, w, h

    def write(self, folder, with_mesh):
        for sub in ('images', 'sparse'):
            os.makedirs(os.path.join(folder, sub), exist_ok=True)
        with open(os.path.join(folder, 'sparse', 'cameras.txt'), 'w') as cameras, \
                open(os.path.join(folder, 'sparse', 'images.txt'), 'w') as images:
            for i, (name, c) in enumerate(sorted(self.cameras.items()), 1):
                cv2.imwrite(os.path.join(folder, 'images', name + '.png'), self.photos[name])
                print(i, 'PINHOLE', c.w, c.h, *(repr(float(x)) for x in (c.fx, c.fy, c.cx, c.cy)), file=cameras)
                pose = [*quaternion(c.R), *c.t]
                print(i, *(repr(float(x)) for x in pose), i, name + '.png\n', file=images)
        if with_mesh:
            faces = np.empty(len(self.F), [('n', 'u1'), ('v', '<i4', 3)])
            faces['n'], faces['v'] = 3, self.F
            with open(os.path.join(folder, 'mesh.ply'), 'wb') as f:
                f.write(('ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty float x\nproperty float y\n'
                         'property float z\nelement face %d\nproperty list uchar int vertex_indices\nend_header\n'
                         % (len(self.V), len(self.F))).encode())
                f.write(self.V.astype('<f4').tobytes() + faces.tobytes())

    def size(self):
        """The diagonal of the bounding box of the central 90 % of the vertices."""
        return np.linalg.norm(np.subtract(*np.percentile(self.V, [95, 5], axis=0)))

    def depth(self, camera):
        """The median depth of the vertices in the frame."""
        x = self.V @ camera.R.T + camera.t
        x = x[x[:, 2] > 0]
        u, v = camera.fx * x[:, 0] / x[:, 2] + camera.cx, camera.fy * x[:, 1] / x[:, 2] + camera.cy
        return np.median(x[(u > 0) & (v > 0) & (u < camera.w) & (v < camera.h), 2])


def move(scene, name, pixels, random):
    c = scene.cameras[name]
    turn, shift = (pixels / np.sqrt(2) / c.fx * np.array([np.cos(a), np.sin(a), 0]) for a in random.uniform(0, 2 * np.pi, 2))
    R = rotation(turn)
    c.R, c.t = R @ c.R, R @ c.t + shift * scene.depth(c)


def move_all(scene, least, most, random):
    for name in sorted(scene.cameras):
        move(scene, name, random.uniform(least, most), random)


def expose(scene, random):
    for name in sorted(scene.photos):
        stops = random.uniform(-0.3, 0.3) + random.uniform(-0.1, 0.1, 3)
        scene.photos[name] = encoded(linear(scene.photos[name]) * 2 ** stops)


def darken_corners(scene):
    for name, c in scene.cameras.items():
        y, x = np.mgrid[:c.h, :c.w] + 0.5
        r2 = ((x - c.cx) ** 2 + (y - c.cy) ** 2) / ((c.w ** 2 + c.h ** 2) / 4)
        a = 1 / np.sqrt(0.65) - 1
        scene.photos[name] = encoded(linear(scene.photos[name]) / (1 + a * r2[..., None]) ** 2)


def paint_figure(photo, random):
    """A striped and mottled figure with a body and a head. It is two fifths as tall as the photo."""
    h, w = photo.shape[:2]
    x, y, tall = int(random.uniform(0.2, 0.8) * w), int(random.uniform(0.35, 0.7) * h), int(0.4 * h)
    mask = np.zeros((h, w), np.uint8)
    cv2.ellipse(mask, (x, y), (tall // 5, int(0.38 * tall)), 0, 0, 360, 255, -1)
    cv2.circle(mask, (x, y - int(0.45 * tall)), tall // 9, 255, -1)
    mottled = cv2.resize(random.uniform(-40, 40, (h // 8, w // 8, 3)), (w, h), interpolation=cv2.INTER_CUBIC)
    stripes = 50 * np.sign(np.sin(np.arange(h) * 2 * np.pi / random.uniform(10, 30)))[:, None, None]
    texture = np.clip(random.uniform(40, 215, 3) + stripes + mottled, 0, 255).astype(np.uint8)
    alpha = cv2.GaussianBlur(mask, (5, 5), 0)[..., None] / 255.0
    return (alpha * texture + (1 - alpha) * photo + 0.5).astype(np.uint8)


def paint_strangers(scene, random):
    for name in sorted(random.choice(sorted(scene.photos), 4, replace=False)):
        for _ in range(2):
            scene.photos[name] = paint_figure(scene.photos[name], random)


def wave(scene, random):
    corners = scene.V[scene.F]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals = np.stack([np.bincount(scene.F.ravel(), np.repeat(across[:, k], 3), len(scene.V)) for k in range(3)], 1)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    size = scene.size()
    height = sum(np.sin(scene.V[:, k] * 2 * np.pi / (size / 6) + random.uniform(0, 2 * np.pi)) for k in range(3)) / 3
    scene.V += 0.003 * size * np.sqrt(3) * height[:, None] * normals  # as strong as one wave of that amplitude


def smooth(scene, rounds=20):
    ends = scene.F.ravel(), scene.F[:, [1, 2, 0]].ravel()
    a, b = np.concatenate(ends), np.concatenate(ends[::-1])
    count = np.maximum(np.bincount(a, minlength=len(scene.V)), 1)
    for _ in range(rounds):
        mean = np.stack([np.bincount(a, scene.V[b, k], len(scene.V)) for k in range(3)], 1) / count[:, None]
        scene.V += 0.5 * (mean - scene.V)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('dataset')
    parser.add_argument('kind')
    parser.add_argument('out')
    parser.add_argument('--kit', required=True, help='folder of the measurement kit')
    parser.add_argument('--max-photo-size', type=int, default=768, help='long side of the downscaled photos in px')
    parser.add_argument('--seed', type=int, default=1)
    a = parser.parse_args()
    sys.path.insert(0, a.kit)
    import dataset
    data = dataset.Dataset(a.dataset)
    scene, random = Scene(data, dataset.load_mesh(data.mesh_path), a.photo_size), np.random.default_rng(a.seed)
    disturbances = {
        'plain': lambda: None,
        'cameras': lambda: move_all(scene, 1, 3, random),
        'slightly': lambda: move_all(scene, 0.5, 1, random),
        'camera': lambda: move(scene, data.names[len(data.names) // 2], 4, random),
        'exposure': lambda: expose(scene, random),
        'vignetting': lambda: darken_corners(scene),
        'strangers': lambda: paint_strangers(scene, random),
        'waves': lambda: wave(scene, random),
        'smooth': lambda: smooth(scene),
    }
    if a.kind not in disturbances:
        parser.error('no kind %s; there are %s' % (a.kind, ', '.join(disturbances)))
    if a.kind == 'vignetting':
        disturbances[a.kind]()
    scene.write(os.path.join(a.out, 'truth'), False)
    if a.kind != 'vignetting':
        disturbances[a.kind]()
    scene.write(os.path.join(a.out, 'scan'), True)


if __name__ == '__main__':
    main()
