using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace FarseerGames.FarseerPhysics.Viewer.Recording;

/// <summary>What happened, one event a row: the frame, the kind, whom it is about, and two numbers.</summary>
internal sealed class EventTrack
{
    /// <summary>The kinds that a recorder asks a simulator for.</summary>
    public const StepEventKinds Wanted =
        StepEventKinds.Contacts | StepEventKinds.Hits | StepEventKinds.Sensors | StepEventKinds.Breaks | StepEventKinds.Sleep;

    // The page reads these numbers: keep them as they are.
    private const int Begun = 0;
    private const int Ended = 1;
    private const int Hit = 2;
    private const int Entered = 3;
    private const int Left = 4;
    private const int JointBroke = 5;
    private const int SpringBroke = 6;
    private const int FellAsleep = 7;
    private const int Woke = 8;

    private const int Frame = 0;
    private const int Kind = 1;
    private const int A = 2;
    private const int B = 3;
    private const int Speed = 4;
    private const int Impulse = 5;

    private int _count;

    public Track Track { get; } = new Track(
        "event",
        new ColumnSpec("frame", ColumnKind.Integer),
        new ColumnSpec("kind", ColumnKind.Byte),
        new ColumnSpec("a", ColumnKind.Integer),
        new ColumnSpec("b", ColumnKind.Integer),
        new ColumnSpec("speed", ColumnKind.Single),
        new ColumnSpec("impulse", ColumnKind.Single));

    public void Record(StepEvents events, GeomTable geoms, BodyTrack bodies, LinkTrack links, int frame)
    {
        foreach (ContactEvent e in events.ContactsBegun)
        {
            Add(frame, Begun, geoms.Find(e.GeomA), geoms.Find(e.GeomB));
        }

        foreach (ContactEvent e in events.ContactsEnded)
        {
            Add(frame, Ended, geoms.Find(e.GeomA), geoms.Find(e.GeomB));
        }

        foreach (HitEvent e in events.Hits)
        {
            Add(frame, Hit, geoms.Find(e.GeomA), geoms.Find(e.GeomB), e.ApproachSpeed, e.NormalImpulse);
        }

        foreach (SensorEvent e in events.SensorsEntered)
        {
            Add(frame, Entered, geoms.Find(e.Sensor), geoms.Find(e.Visitor));
        }

        foreach (SensorEvent e in events.SensorsLeft)
        {
            Add(frame, Left, geoms.Find(e.Sensor), geoms.Find(e.Visitor));
        }

        foreach (Joint joint in events.BrokenJoints)
        {
            Add(frame, JointBroke, links.Find(joint), -1);
        }

        foreach (Spring spring in events.BrokenSprings)
        {
            Add(frame, SpringBroke, links.Find(spring), -1);
        }

        foreach (Body body in events.FellAsleep)
        {
            Add(frame, FellAsleep, bodies.Find(body), -1);
        }

        foreach (Body body in events.Woke)
        {
            Add(frame, Woke, bodies.Find(body), -1);
        }
    }

    /// <summary>The events of a chunk: one row of as many slots as there are events.</summary>
    public void Pack(int first)
    {
        Track.Pack(first, keepSlots: false);
        _count = 0;
    }

    private void Add(int frame, int kind, int a, int b, float speed = 0, float impulse = 0)
    {
        if (_count == 0)
        {
            Track.Begin(0);
        }

        int slot = _count++;
        Track.Grow(_count);
        Track.Set(slot, Frame, frame);
        Track.Set(slot, Kind, kind);
        Track.Set(slot, A, a);
        Track.Set(slot, B, b);
        Track.Set(slot, Speed, speed);
        Track.Set(slot, Impulse, impulse);
    }
}
