using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Islands;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// Bodies that rest fall asleep, all at once that hang together by contacts, joints and springs. No phase of a step looks at them. Their
/// contacts keep rows and impulses, and come back warm when something wakes them; listeners hear of neither.
/// </summary>
internal sealed partial class SleepStage : WorldPhase
{
    /// <summary>Springs come and go in each step: a group that one of them has left is found after so many.</summary>
    private const int MostStepsUngrouped = 32;
    private readonly ContactEvents _events;
    private readonly ContactStage _contactStage;
    private readonly RestJudge _rest = new RestJudge();
    private readonly DormantContacts _dormant = new DormantContacts();
    private readonly IndexList _put = new IndexList();
    private readonly IndexList _putInStep = new IndexList();
    private readonly IndexList _handled = new IndexList();
    private readonly IndexList _layDown = new IndexList();
    private int _stepsUngrouped;
    private Vector2 _gravityAsleep;
    private float _dt;
    private bool _bodiesCollected;

    public SleepStage(WorldStores stores, ContactEvents events, ContactStage contactStage)
        : base(stores)
    {
        _events = events;
        _contactStage = contactStage;
    }

    /// <summary>Bodies asleep.</summary>
    public int AsleepCount { get; private set; }

    /// <summary>Bodies have come into touch, or parted.</summary>
    public bool GroupsChanged { get; set; }

    /// <summary>Makes room for more bodies.</summary>
    public void EnsureBodies(int end)
    {
        if (_settings.AllowSleep)
        {
            _rest.EnsureBodies(end);
        }
    }

    /// <summary>
    /// Makes room for as many bodies and contacts as there are to fall asleep and to wake, which may be after a thousand steps.
    /// </summary>
    public void Reserve()
    {
        if (_settings.AllowSleep && _bodies.Ids.End > 1)
        {
            int bodies = _bodies.State.Capacity;
            _rest.Reserve(bodies);
            _flood.Reserve(bodies);
            _handled.Reserve(bodies);
            _layDown.Reserve(_contacts.Records.Capacity);
            _dormant.Reserve(_contacts.Records.Capacity, bodies);
        }
    }

    /// <summary>A body has to rest anew before it falls asleep.</summary>
    public void Restart(int body) => _rest.Restart(body);

    public bool IsAwake(Handle body)
    {
        _bodies.Ids.Require(body, nameof(body));
        return !_bodies.IsAsleep(body.Index);
    }

    /// <summary>Wakes a body and all that hangs together with it. An awake one has to rest anew before it falls asleep.</summary>
    public void WakeUp(Handle body)
    {
        _bodies.Ids.Require(body, nameof(body));
        Wake(body.Index);
    }

    /// <summary>Wakes the body in a slot, if one is there.</summary>
    public void WakeUp(int body)
    {
        if (body > 0 && body < _bodies.Ids.End)
        {
            Wake(body);
        }
    }

    public void WakeAll()
    {
        for (int body = 1; AsleepCount > 0 && body < _bodies.Ids.End; body++)
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
        _bodies.Ids.Require(body, nameof(body));
        if (_stores.IsStepping)
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
        if ((_bodies.Flags[body] & (BodyFlags.Asleep | BodyFlags.Handled)) == BodyFlags.Asleep)
        {
            _bodies.Flags[body] |= BodyFlags.Handled;
            _handled.Add(body);
        }
    }

    /// <summary>Joints that a user wrote may hold any body, which only they know.</summary>
    private bool IsSleepBarred => _stores.AnyUserJoints;

    /// <summary>At the end of a step: lays down what has rested for long enough.</summary>
    public unsafe void FallAsleep(float dt)
    {
        _bodiesCollected = false;
        bool any = _put.Count > 0;
        _rest.Resting.Clear();
        if (_settings.AllowSleep && !IsSleepBarred)
        {
            RestInput input;
            input.Bodies = _bodies;
            input.Settings = _settings;
            input.Active = _lists.Active;
            input.ActiveCount = _lists.ActiveCount;
            input.Moves = _lists.Moves;
            input.Degrees = _graph.Degrees;
            input.Islands = _islands;
            input.Dt = dt;
            bool isDue = _rest.Watch(_stores.Runner, input);
            if (_rest.AnyRested
                && (!_graph.Changed || _graph.RowCount == 0)
                && (isDue || GroupsChanged || ++_stepsUngrouped >= MostStepsUngrouped))
            {
                GroupsChanged = false;
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
            _events.LeaveOut();
            Leave(_rest.Resting);
            Leave(_put);
        }

        _put.Clear();
        for (int i = 0; i < _putInStep.Count; i++)
        {
            int body = _putInStep[i];
            if (_bodies.Ids.IsUsed(body) && MayLieDown(body))
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
        for (int joint = 0; joint < _joints.Ids.End; joint++)
        {
            const JointFlags Acts = JointFlags.Alive | JointFlags.Enabled;
            JointLink link = _joints.Links[joint];
            if ((_joints.Flags[joint] & Acts) == Acts && (input.Moves[link.BodyA] & input.Moves[link.BodyB]) != 0)
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
        (_bodies.IsAsleep(bodyA) || _bodies.IsAsleep(bodyB)) && _bodies.IsStill(bodyA) && _bodies.IsStill(bodyB);

    private bool IsDriven(int body) => !_bodies.IsMovable(body) && !_bodies.IsStill(body);

    private bool MayLieDown(int body)
    {
        const BodyFlags Awake = BodyFlags.Alive | BodyFlags.Enabled;
        const BodyFlags All = Awake | BodyFlags.Static | BodyFlags.Kinematic | BodyFlags.Asleep | BodyFlags.NeverSleeps;
        return (_bodies.Flags[body] & All) == Awake && _settings.AllowSleep && !IsSleepBarred;
    }

    private void LieDown(int body)
    {
        AsleepCount++;
        _bodies.Flags[body] |= BodyFlags.Asleep;
        ref BodyState state = ref _bodies.State[body];
        state.LinearVelocity = Vector2.Zero;
        state.AngularVelocity = 0;
        _bodies.Motion[body] = default;
        _bodies.ClearResidual(body);
        _bodies.Force[body] = default;
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
            _dormant.Reserve(_contacts.Records.Capacity, _bodies.State.Capacity);
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
            if (!_bodies.IsAsleep(body))
            {
                continue;
            }

            _bodies.Visited.Clear(body);
            for (int collider = _colliders.First(body); collider >= 0; collider = _colliders.Next(collider))
            {
                for (int piece = _shapes.Colliders[collider].FirstPiece; piece >= 0; piece = _shapes.NextPiece[piece])
                {
                    _shapes.VisitedPieces.Clear(piece);
                    _contactStage.WriteSides(_stores, _lists.Moves, piece);
                    if (_queries.IsUsed)
                    {
                        _queries.Changed(piece);
                    }
                }
            }
        }
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        _rest.Visit(s.Of(nameof(_rest)));
        _dormant.Visit(s.Of(nameof(_dormant)));
        _put.Visit(s.Of(nameof(_put)));
        _putInStep.Visit(s.Of(nameof(_putInStep)));
        _handled.Visit(s.Of(nameof(_handled)));
        _layDown.Visit(s.Of(nameof(_layDown)));
        s.Of(nameof(SleepStage)).Value(ref _stepsUngrouped);
        GroupsChanged = s.Value(GroupsChanged);
        s.Value(ref _gravityAsleep);
        s.Value(ref _dt);
        s.Value(ref _bodiesCollected);
        AsleepCount = s.Value(AsleepCount);
    }
}
