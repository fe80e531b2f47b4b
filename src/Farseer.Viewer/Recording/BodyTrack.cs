using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Viewer.Recording;

/// <summary>Where bodies are, how they move, and in which state.</summary>
internal sealed class BodyTrack
{
    public const int X = 0;
    public const int Y = 1;
    public const int Angle = 2;
    public const int SpeedX = 3;
    public const int SpeedY = 4;
    public const int Spin = 5;
    public const int Mass = 6;
    public const int Inertia = 7;
    public const int Flags = 8;

    // The page reads these bits: keep them as they are.
    private const int IsThere = 1;
    private const int IsAwake = 2;
    private const int IsEnabled = 4;
    private const int IsStatic = 8;
    private const int IsKinematic = 16;
    private const int IsQuarantined = 32;

    /// <summary>Bits of bodies that nothing moves.</summary>
    public const int Fixed = IsStatic | IsKinematic;

    private readonly References<Body> _bodies = new References<Body>();

    public Track Track { get; } = new Track(
        "body",
        new ColumnSpec("x", ColumnKind.Double, Digits.Place),
        new ColumnSpec("y", ColumnKind.Double, Digits.Place),
        new ColumnSpec("angle", ColumnKind.Double, Digits.Angle),
        new ColumnSpec("vx", ColumnKind.Single, Digits.Length),
        new ColumnSpec("vy", ColumnKind.Single, Digits.Length),
        new ColumnSpec("spin", ColumnKind.Single, Digits.Spin),
        new ColumnSpec("mass", ColumnKind.Single),
        new ColumnSpec("inertia", ColumnKind.Single),
        new ColumnSpec("flags", ColumnKind.Byte));

    /// <summary>What each is called; null without a name.</summary>
    public List<string?> Names { get; } = new List<string?>();

    public int Find(Body? body) => _bodies.Find(body);

    public void Record(BodyList bodies)
    {
        Track.Begin(_bodies.Count);
        Track.Clear(Flags);
        for (int i = 0; i < bodies.Count; i++)
        {
            Take(bodies[i]);
        }
    }

    /// <summary>The number of a body of which a geom is in the simulator, whether or not the body is.</summary>
    public int Take(Body body)
    {
        int slot = _bodies.Number(body, out bool isNew);
        if (isNew)
        {
            Names.Add(Label.Of(body.Name, body.Tag));
            Track.Grow(slot + 1);
        }

        body.GetPosition(out double x, out double y);
        body.GetTotalRotation(out double angle);
        Track.Set(slot, X, x);
        Track.Set(slot, Y, y);
        Track.Set(slot, Angle, angle);
        Track.Set(slot, SpeedX, body.LinearVelocity.X);
        Track.Set(slot, SpeedY, body.LinearVelocity.Y);
        Track.Set(slot, Spin, body.AngularVelocity);
        Track.Set(slot, Mass, body.Mass);
        Track.Set(slot, Inertia, body.MomentOfInertia);
        Track.Set(slot, Flags, FlagsOf(body));
        return slot;
    }

    private static int FlagsOf(Body body) =>
        IsThere
        | (body.Awake ? IsAwake : 0)
        | (body.Enabled ? IsEnabled : 0)
        | (body.IsStatic ? IsStatic : 0)
        | (body.IsKinematic ? IsKinematic : 0)
        | (body.IsQuarantined ? IsQuarantined : 0);
}
