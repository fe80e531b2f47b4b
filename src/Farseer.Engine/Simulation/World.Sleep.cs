using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Islands;
using Farseer.Engine.Joints;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// Bodies that rest fall asleep, all at once that hang together by contacts, joints and springs. No phase of a step looks at them. Their
/// contacts keep rows and impulses, and come back warm when something wakes them; listeners hear of neither.
/// </summary>
internal sealed partial class World
{
    /// <summary>Springs come and go in each step: a group that one of them has left is found after so many.</summary>
    private const int MostStepsUngrouped = 32;

    private readonly RestJudge _rest = new RestJudge();
    private readonly DormantContacts _dormant = new DormantContacts();
    private readonly IndexList _put = new IndexList();
    private readonly IndexList _putInStep = new IndexList();
    private readonly IndexList _handled = new IndexList();
    private readonly IndexList _layDown = new IndexList();
    private int _stepsUngrouped;
    private bool _groupsChanged;
    private Vector2 _gravityAsleep;
    private float _dt;
    private bool _bodiesCollected;

    /// <summary>Bodies asleep.</summary>
    public int AsleepCount { get; private set; }

    public bool IsAwake(Handle body)
    {
        Require(body);
        return !IsAsleep(body.Index);
    }

    /// <summary>Wakes a body and all that hangs together with it. An awake one has to rest anew before it falls asleep.</summary>
    public void WakeUp(Handle body)
    {
        Require(body);
        Wake(body.Index);
    }

    /// <summary>Wakes the body in a slot, if one is there.</summary>
    public void WakeUp(int body)
    {
        if (body > 0 && body < Bodies.Ids.End)
        {
            Wake(body);
        }
    }

    /// <summary>Material or listeners of a collider changed: its body wakes, and so does what rests on it.</summary>
    public void NoteChanged(Handle collider)
    {
        Require(collider, Shapes.ColliderIds, nameof(collider));
        ref ColliderInfo info = ref Shapes.Colliders[collider.Index];
        _makesEnergy |= info.Restitution > 1;
        Disturb(info.Body);
    }

    public void WakeAll()
    {
        for (int body = 1; AsleepCount > 0 && body < Bodies.Ids.End; body++)
        {
            Wake(body);
        }
    }

    /// <summary>
    /// Stops a body and puts it to sleep; within a step, at its end. The next step wakes it if something awake is in touch with it. Of
    /// no effect on what cannot fall asleep.
    /// </summary>
    public void PutToSleep(Handle body)
    {
        Require(body);
        if (IsStepping)
        {
            _putInStep.Add(body.Index);
        }
        else if (MayLieDown(body.Index))
        {
            LieDown(body.Index);
            _put.Add(body.Index);
        }
    }

    /// <summary>Somebody got hold of a sleeping body's velocity and may set it: the next step looks.</summary>
    public void NoteHandled(int body)
    {
        if ((Bodies.Flags[body] & (BodyFlags.Asleep | BodyFlags.Handled)) == BodyFlags.Asleep)
        {
            Bodies.Flags[body] |= BodyFlags.Handled;
            _handled.Add(body);
        }
    }

    /// <summary>Whether nothing moves a body: it sleeps, or is static or kinematic and has no velocity.</summary>
    internal bool IsStill(int body)
    {
        BodyFlags flags = Bodies.Flags[body];
        if ((flags & (BodyFlags.Static | BodyFlags.Kinematic)) != 0)
        {
            ref BodyState state = ref Bodies.State[body];
            return state.LinearVelocity == Vector2.Zero && state.AngularVelocity == 0;
        }

        return (flags & BodyFlags.Asleep) != 0 || (flags & BodyFlags.Enabled) == 0;
    }

    private bool IsAsleep(int body) => (Bodies.Flags[body] & BodyFlags.Asleep) != 0;

    private bool CanMove(int body) => (Bodies.Flags[body] & (BodyFlags.Static | BodyFlags.Kinematic)) == 0;

    /// <summary>Joints that a user wrote may hold any body, which only they know.</summary>
    private bool IsSleepBarred => UserJoints != null && UserJoints.Any;

    /// <summary>At the end of a step: lays down what has rested for long enough.</summary>
    private unsafe void FallAsleep(float dt)
    {
        _bodiesCollected = false;
        bool any = _put.Count > 0;
        _rest.Resting.Clear();
        if (Settings.AllowSleep && !IsSleepBarred)
        {
            RestInput input;
            input.Bodies = Bodies;
            input.Settings = Settings;
            input.Active = _lists.Active;
            input.ActiveCount = _lists.ActiveCount;
            input.Moves = _lists.Moves;
            input.Degrees = _graph.Degrees;
            input.Islands = _islands;
            input.Dt = dt;
            bool isDue = _rest.Watch(_runner, input);
            if (_rest.AnyRested && (!_graph.Changed || _graph.RowCount == 0) && (isDue || _groupsChanged || ++_stepsUngrouped >= MostStepsUngrouped))
            {
                _groupsChanged = false;
                _stepsUngrouped = 0;
                FormGroups(input);
            }
        }

        for (int i = 0; i < _rest.Resting.Count; i++)
        {
            LieDown(_rest.Resting[i]);
            any = true;
        }

        if (any)
        {
            LayDownContacts();
            _events.LeaveOut(this);
            Leave(_rest.Resting);
            Leave(_put);
        }

        _put.Clear();
        for (int i = 0; i < _putInStep.Count; i++)
        {
            int body = _putInStep[i];
            if (Bodies.Ids.IsUsed(body) && MayLieDown(body))
            {
                LieDown(body);
                _put.Add(body);
            }
        }

        _putInStep.Clear();
    }

    private unsafe void FormGroups(in RestInput input)
    {
        // Not only those that the step began with: a handler may have set one going since.
        RestartBesideDriven();
        _rest.Open(input);
        for (int joint = 0; joint < Joints.Ids.End; joint++)
        {
            const JointFlags Acts = JointFlags.Alive | JointFlags.Enabled;
            JointLink link = Joints.Links[joint];
            if ((Joints.Flags[joint] & Acts) == Acts && (input.Moves[link.BodyA] & input.Moves[link.BodyB]) != 0)
            {
                _rest.Join(link.BodyA, link.BodyB);
            }
        }

        for (int i = 0; i < _springs.Count; i++)
        {
            _springs.Ends(i, out int a, out int b);
            if ((input.Moves[a] & input.Moves[b]) != 0)
            {
                _rest.Join(a, b);
            }
        }

        _rest.Close(input);
    }

    private unsafe void RestartBesideDriven()
    {
        foreach (GraphColor color in _graph.Used)
        {
            foreach (ContactBundle* row in color.Bundles)
            {
                for (int lane = 0; lane < ContactBundle.Lanes; lane++)
                {
                    if (row->Contact[lane] >= 0 && (IsDriven(row->BodyA[lane]) || IsDriven(row->BodyB[lane])))
                    {
                        _rest.Restart(row->BodyA[lane]);
                        _rest.Restart(row->BodyB[lane]);
                    }
                }
            }
        }
    }

    private bool Sleeps(int bodyA, int bodyB) =>
        (IsAsleep(bodyA) || IsAsleep(bodyB)) && IsStill(bodyA) && IsStill(bodyB);

    private bool IsDriven(int body) => !CanMove(body) && !IsStill(body);

    private bool MayLieDown(int body)
    {
        const BodyFlags Awake = BodyFlags.Alive | BodyFlags.Enabled;
        const BodyFlags All = Awake | BodyFlags.Static | BodyFlags.Kinematic | BodyFlags.Asleep | BodyFlags.NeverSleeps;
        return (Bodies.Flags[body] & All) == Awake && Settings.AllowSleep && !IsSleepBarred;
    }

    private void LieDown(int body)
    {
        AsleepCount++;
        Bodies.Flags[body] |= BodyFlags.Asleep;
        ref BodyState state = ref Bodies.State[body];
        state.LinearVelocity = Vector2.Zero;
        state.AngularVelocity = 0;
        Bodies.Motion[body] = default;
        Bodies.ClearResidual(body);
        Bodies.Force[body] = default;
        _lists.SetMoving(body, false);
    }

    /// <summary>Takes the pairs out of the step of which no side moves.</summary>
    private unsafe void LayDownContacts()
    {
        _layDown.Clear();
        _layDown.Reserve(_contacts.Records.Capacity);
        foreach (GraphColor color in _graph.Used)
        {
            foreach (ContactBundle* row in color.Bundles)
            {
                for (int lane = 0; lane < ContactBundle.Lanes; lane++)
                {
                    if (row->Contact[lane] >= 0 && Sleeps(row->BodyA[lane], row->BodyB[lane]))
                    {
                        _layDown.Add(row->Contact[lane]);
                    }
                }
            }
        }

        for (int i = 0; i < _contacts.IdleCount; i++)
        {
            ref ContactRecord record = ref _contacts.Records[_contacts.Idle(i)];
            if (Sleeps(record.BodyA, record.BodyB))
            {
                _layDown.Add(_contacts.Idle(i));
            }
        }

        if (_layDown.Count > 0)
        {
            _dormant.Reserve(_contacts.Records.Capacity, Bodies.State.Capacity);
        }

        for (int i = 0; i < _layDown.Count; i++)
        {
            int contact = _layDown[i];
            ref ContactRecord record = ref _contacts.Records[contact];
            if (record.Color >= 0)
            {
                _graph.LayDown(ref record, _contacts.Records);
            }
            else
            {
                _contacts.LayDown(contact);
            }

            _dormant.Add(contact, record);
        }
    }

    /// <summary>From now on no phase looks at these bodies.</summary>
    private unsafe void Leave(IndexList bodies)
    {
        for (int i = 0; i < bodies.Count; i++)
        {
            int body = bodies[i];
            if (!IsAsleep(body))
            {
                continue;
            }

            Bodies.Visited.Clear(body);
            for (int collider = _firstCollider[body]; collider >= 0; collider = _nextCollider[collider])
            {
                for (int piece = Shapes.Colliders[collider].FirstPiece; piece >= 0; piece = Shapes.NextPiece[piece])
                {
                    Shapes.VisitedPieces.Clear(piece);
                    _contactStage.WriteSides(this, _lists.Moves, piece);
                    if (Queries.IsUsed)
                    {
                        Queries.Changed(piece);
                    }
                }
            }
        }
    }
}
