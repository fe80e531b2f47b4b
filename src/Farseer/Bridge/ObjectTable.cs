using System;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>Engine index to body or geom: what the step's hooks see are indices.</summary>
internal sealed class ObjectTable
{
    private Body?[] _bodies = new Body?[16];
    private Geom?[] _geoms = new Geom?[16];

    /// <summary>One past the highest index that may hold a body.</summary>
    public int BodyEnd => _bodies.Length;

    /// <summary>One past the highest index that may hold a geom.</summary>
    public int GeomEnd => _geoms.Length;

    public Body? Body(int index) => index < _bodies.Length ? _bodies[index] : null;

    public Geom? Geom(int index) => index < _geoms.Length ? _geoms[index] : null;

    public void SetBody(int index, Body? body)
    {
        if (index >= _bodies.Length)
        {
            Array.Resize(ref _bodies, Math.Max(index + 1, _bodies.Length * 2));
        }

        _bodies[index] = body;
    }

    public void SetGeom(int index, Geom? geom)
    {
        if (index >= _geoms.Length)
        {
            Array.Resize(ref _geoms, Math.Max(index + 1, _geoms.Length * 2));
        }

        _geoms[index] = geom;
    }
}
