using System;
using Farseer.Engine.Storage;
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

    /// <summary>Makes room for indices below these.</summary>
    public void Expect(int bodyEnd, int geomEnd)
    {
        EnsureLength(ref _bodies, bodyEnd);
        EnsureLength(ref _geoms, geomEnd);
    }

    public Body? Body(int index) => index < _bodies.Length ? _bodies[index] : null;

    public Geom? Geom(int index) => index < _geoms.Length ? _geoms[index] : null;

    public void SetBody(int index, Body? body)
    {
        EnsureLength(ref _bodies, index + 1);
        _bodies[index] = body;
    }

    public void SetGeom(int index, Geom? geom)
    {
        EnsureLength(ref _geoms, index + 1);
        _geoms[index] = geom;
    }

    private static void EnsureLength<T>(ref T?[] items, int length)
    {
        if (length > items.Length)
        {
            Array.Resize(ref items, Math.Max(length, items.Length + (items.Length / 4)));
        }
    }

    /// <summary>Nothing is anywhere.</summary>
    public void Clear()
    {
        Array.Clear(_bodies, 0, _bodies.Length);
        Array.Clear(_geoms, 0, _geoms.Length);
    }
}
