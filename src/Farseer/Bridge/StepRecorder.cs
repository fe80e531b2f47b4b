using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Shapes;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>Keeps the events of an update until they are read. There is none unless some kind was asked for.</summary>
internal sealed class StepRecorder
{
    /// <summary>By place in the table of bodies: where a body was when moves were last told of, and whether it slept.</summary>
    private BodyPose[] _told = [];
    private bool[] _slept = [];

    [NotState(Why.Calm)]
    public PairEventBuffer<ContactEvent> Begun { get; } = new PairEventBuffer<ContactEvent>();

    [NotState(Why.Calm)]
    public PairEventBuffer<ContactEvent> Ended { get; } = new PairEventBuffer<ContactEvent>();

    [NotState(Why.Calm)]
    public PairEventBuffer<HitEvent> Hits { get; } = new PairEventBuffer<HitEvent>();

    [NotState(Why.Calm)]
    public PairEventBuffer<PushEvent> Pushes { get; } = new PairEventBuffer<PushEvent>();

    [NotState(Why.Calm)]
    public PairEventBuffer<SensorEvent> Entered { get; } = new PairEventBuffer<SensorEvent>();

    [NotState(Why.Calm)]
    public PairEventBuffer<SensorEvent> Left { get; } = new PairEventBuffer<SensorEvent>();

    [NotState(Why.Calm)]
    public EventBuffer<Joint> Joints { get; } = new EventBuffer<Joint>();

    [NotState(Why.Calm)]
    public EventBuffer<Spring> Springs { get; } = new EventBuffer<Spring>();

    [NotState(Why.Calm)]
    public EventBuffer<Body> Asleep { get; } = new EventBuffer<Body>();

    [NotState(Why.Calm)]
    public EventBuffer<Body> Awake { get; } = new EventBuffer<Body>();

    [NotState(Why.Calm)]
    public EventBuffer<Body> Moved { get; } = new EventBuffer<Body>();

    public StepEventKinds Kinds { get; set; }

    /// <summary>Of an update that went back in time there is nothing to read.</summary>
    public void Visit(StateStream s)
    {
        Kinds = s.Value(Kinds);
        s.Sized(ref _told);
        s.Sized(ref _slept);
        if (s.IsReading)
        {
            Clear();
        }
    }

    /// <summary>What the engine is to tell of a geom.</summary>
    public ColliderFlags WantedOf(bool isSensor)
    {
        const ColliderFlags Both = ColliderFlags.WantsContact | ColliderFlags.WantsSeparation;
        bool all = (Kinds & StepEventKinds.Contacts) != 0 || (isSensor && (Kinds & StepEventKinds.Sensors) != 0);
        return all ? Both : (Kinds & (StepEventKinds.Hits | StepEventKinds.Pushes)) != 0 ? ColliderFlags.WantsContact : ColliderFlags.None;
    }

    /// <summary>Two geoms touch, the older one first.</summary>
    public void Begin(Geom a, Geom b) => Note(a, b, Begun, Entered);

    /// <summary>Two geoms touch no more.</summary>
    public void End(Geom a, Geom b) => Note(a, b, Ended, Left);

    public void Push(Geom a, Geom b, in PushRecord push, bool flip)
    {
        if ((Kinds & StepEventKinds.Hits) != 0 && push.IsHit)
        {
            Vector2 point = new Vector2((float)push.X, (float)push.Y);
            Hits.Add(new HitEvent(a, b, point, flip ? -push.Normal : push.Normal, push.Approach, push.NormalImpulse, push.TangentImpulse));
        }

        if ((Kinds & StepEventKinds.Pushes) != 0)
        {
            var impulse = new Vector2((float)push.PushX, (float)push.PushY);
            Pushes.Add(new PushEvent(a, b, flip ? -impulse : impulse));
        }
    }

    public void Broke(Joint joint)
    {
        if ((Kinds & StepEventKinds.Breaks) != 0)
        {
            Joints.Add(joint);
        }
    }

    public void Broke(Spring spring)
    {
        if ((Kinds & StepEventKinds.Breaks) != 0)
        {
            Springs.Add(spring);
        }
    }

    /// <summary>A body came, or its moves are told of from now on.</summary>
    public void Take(Body body)
    {
        const StepEventKinds OfBodies = StepEventKinds.Moves | StepEventKinds.Sleep;
        if ((Kinds & OfBodies) != 0 && body.Link.World is not null)
        {
            int place = body.Link.Handle.Index;
            if (place >= _told.Length)
            {
                Array.Resize(ref _told, Math.Max(16, place * 2));
                Array.Resize(ref _slept, _told.Length);
            }

            _told[place] = body.Link.PoseRef;
            _slept[place] = !body.Awake;
        }
    }

    /// <summary>Lets readers see the events of an update.</summary>
    public void Publish(BodyList bodies)
    {
        if ((Kinds & (StepEventKinds.Moves | StepEventKinds.Sleep)) != 0)
        {
            LookAtBodies(bodies);
        }

        Begun.Publish();
        Ended.Publish();
        Hits.Publish();
        Pushes.Publish();
        Entered.Publish();
        Left.Publish();
        Joints.Publish();
        Springs.Publish();
        Asleep.Publish();
        Awake.Publish();
        Moved.Publish();
    }

    public void Clear()
    {
        Begun.Clear();
        Ended.Clear();
        Hits.Clear();
        Pushes.Clear();
        Entered.Clear();
        Left.Clear();
        Joints.Clear();
        Springs.Clear();
        Asleep.Clear();
        Awake.Clear();
        Moved.Clear();
    }

    private void Note(Geom a, Geom b, EventBuffer<ContactEvent> contacts, EventBuffer<SensorEvent> sensors)
    {
        if (!a.IsSensor && !b.IsSensor)
        {
            if ((Kinds & StepEventKinds.Contacts) != 0)
            {
                contacts.Add(new ContactEvent(a, b));
            }

            return;
        }

        if ((Kinds & StepEventKinds.Sensors) == 0)
        {
            return;
        }

        if (a.IsSensor)
        {
            sensors.Add(new SensorEvent(a, b));
        }

        if (b.IsSensor)
        {
            sensors.Add(new SensorEvent(b, a));
        }
    }

    private void LookAtBodies(BodyList bodies)
    {
        for (int i = 0; i < bodies.Count; i++)
        {
            Body body = bodies[i];
            if (body.Link.World is null)
            {
                continue;
            }

            int place = body.Link.Handle.Index;
            bool sleeps = !body.Awake;
            if (sleeps != _slept[place])
            {
                _slept[place] = sleeps;
                if ((Kinds & StepEventKinds.Sleep) != 0)
                {
                    (sleeps ? Asleep : Awake).Add(body);
                }
            }

            BodyPose now = body.Link.PoseRef;
            ref BodyPose told = ref _told[place];
            if (now.X != told.X || now.Y != told.Y || now.Angle != told.Angle)
            {
                told = now;
                if ((Kinds & StepEventKinds.Moves) != 0)
                {
                    Moved.Add(body);
                }
            }
        }
    }
}
