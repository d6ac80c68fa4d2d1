# SPDX-License-Identifier: MIT
"""A scene with every default written out, as the scene file's reference lists them.

Both models read scenes through completed(), so neither of them knows a default of its own.  A scene is what
json.load() gives; the numbers are left as they are.
"""

MATERIAL = {'model': 'blinn-phong', 'diffuse': 0.8, 'specular': 0.5, 'shininess': 20, 'over_pi': False,
            'highlight': 'plain', 'normalized': False}

LIGHT = {
    'ambient': {},
    'distant': {},
    'point': {'pattern': 'isotropic', 'exponent': 0, 'axis': [0, 0, -1], 'attenuation': 'inverse-square'},
    'spot': {'falloff': 'smoothstep', 'exponent': 0, 'axis': [0, 0, -1], 'attenuation': 'inverse-square'},
    'planar': {'attenuation': 'inverse-square', 'parts': 'converged'},
    'volume': {'attenuation': 'inverse-square', 'parts': 'converged'},
}


def completed(scene):
    """Returns a copy with the defaults; disabled lights are left out."""
    return {
        'units': scene.get('units', 'radiometric'),
        'shadows': scene.get('shadows', 'all'),
        'screen': {'sampling': 'centers', **scene['screen']},
        'observer': {'projection': 'orthographic', 'view': 'parallel', **scene['observer']},
        'surfaces': [_surface(surface) for surface in scene['surfaces']],
        'lights': [{**LIGHT[light['type']], **light} for light in scene['lights'] if light.get('enabled', True)],
        'picture': {'range': 'max', 'rounding': 'truncate', **scene.get('picture', {})},
    }


def _surface(surface):
    material = {**MATERIAL, **surface.get('material', {})}
    material.setdefault('ambient', material['diffuse'])
    return {**surface, 'material': material}
