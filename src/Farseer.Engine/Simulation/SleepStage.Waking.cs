using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <content>What wakes bodies: changes from outside, awake bodies that come into touch, springs, and the ground when it moves.</content>
internal sealed partial class SleepStage
{
    [NotState(Why.OfOneStep)]
    private readonly IndexList _flood = new IndexList();

    /// <summary>A pair that is about to touch wakes the side that sleeps.</summary>
    /// <returns>False if both sides go on sleeping: nothing has come near, they were put to sleep where they touch.</returns>
    public bool WakeByContact(in ContactRecord record)
    {
        bool asleepA = _bodies.IsAsleep(record.BodyA);
        bool asleepB = _bodies.IsAsleep(record.BodyB);
        if (!asleepA && !asleepB)
        {
            return true;
        }

        int piece = asleepA ? record.PieceA : record.PieceB;
        bool isFresh = (_proxies.Info[piece].Flags & ProxyFlags.Moved) != 0;
        if ((asleepA && asleepB) || (isFresh && _bodies.IsStill(asleepA ? record.BodyB : record.BodyA)))
        {
            return false;
        }

        Wake(asleepA ? record.BodyA : record.BodyB);
        return true;
    }

    /// <summary>A spring wakes a sleeping end if the other end moves.</summary>
    /// <returns>False if no end is awake: the spring has nothing to do.</returns>
    public bool WakesBySpring(int bodyA, int bodyB)
    {
        bool asleepA = _bodies.IsAsleep(bodyA);
        bool asleepB = _bodies.IsAsleep(bodyB);
        if ((asleepA && _bodies.IsStill(bodyB)) || (asleepB && _bodies.IsStill(bodyA)))
        {
            return false;
        }

        if (asleepA || asleepB)
        {
            Wake(asleepA ? bodyA : bodyB);
        }

        return true;
    }

    /// <summary>
    /// A body was changed from outside: it wakes, and so does what rests on it. One that was put to sleep and has not seen a step since is
    /// still being built.
    /// </summary>
    public void Disturb(int body)
    {
        _rest.Restart(body);
        if (AsleepCount == 0 || body == 0)
        {
            return;
        }

        if (!_bodies.IsAsleep(body))
        {
            WakeTouching(body);
        }
        else if ((_bodies.Flags[body] & BodyFlags.Moved) == 0)
        {
            Wake(body);
        }
    }

    /// <summary>A joint at the body changed.</summary>
    public void DisturbByJoint(int body)
    {
        _rest.Restart(body);
        if (_bodies.IsAsleep(body) && (_bodies.Flags[body] & BodyFlags.Moved) == 0)
        {
            Wake(body);
        }
    }

    /// <summary>Wakes all that rests on a body which is not asleep itself.</summary>
    private void WakeTouching(int body)
    {
        for (int entry = _dormant.First(body); entry >= 0; entry = _dormant.First(body))
        {
            WakeBodiesOf(_contacts.Records[entry >> 1]);
        }

        for (int entry = _joints.First(body); entry >= 0; entry = _joints.Next(entry))
        {
            JointLink link = _joints.Links[entry >> 1];
            Wake(link.BodyA == body ? link.BodyB : link.BodyA);
        }
    }

    public void WakeBodiesOf(ContactRecord record)
    {
        Wake(record.BodyA);
        Wake(record.BodyB);
    }

    /// <summary>Floods from a body over the rows and joints that sleep.</summary>
    public void Wake(int body)
    {
        _rest.Restart(body);
        if (!_bodies.IsAsleep(body))
        {
            return;
        }

        _flood.Clear();
        Reach(body);
        for (int i = 0; i < _flood.Count; i++)
        {
            int woken = _flood[i];
            for (int entry = _dormant.First(woken); entry >= 0; entry = _dormant.First(woken))
            {
                TakeUp(entry >> 1, woken);
            }

            for (int entry = _joints.First(woken); entry >= 0; entry = _joints.Next(entry))
            {
                JointLink link = _joints.Links[entry >> 1];
                if ((_joints.Flags[entry >> 1] & JointFlags.Enabled) != 0)
                {
                    Reach(link.BodyA == woken ? link.BodyB : link.BodyA);
                }
            }
        }
    }

    /// <summary>Gets a body up, if it sleeps.</summary>
    private void Reach(int body)
    {
        if (!_bodies.IsAsleep(body))
        {
            return;
        }

        AsleepCount--;
        _bodies.Flags[body] &= ~(BodyFlags.Asleep | BodyFlags.Handled);
        _bodies.Visited.Set(body);
        _rest.Restart(body);
        for (int collider = _colliders.First(body); collider >= 0; collider = _colliders.Next(collider))
        {
            for (int piece = _shapes.Colliders[collider].FirstPiece; piece >= 0; piece = _shapes.NextPiece[piece])
            {
                _shapes.VisitedPieces.Set(piece);
            }
        }

        _lists.SetMoving(body, true);
        if (_bodiesCollected)
        {
            _lists.Join(_bodies, body, _dt);
        }

        _flood.Add(body);
    }

    private void TakeUp(int contact, int woken)
    {
        ref ContactRecord record = ref _contacts.Records[contact];
        _dormant.Remove(contact, record);
        if (record.Color == ContactRecord.DormantRow)
        {
            _graph.TakeUp(contact, ref record, _contacts.Records, _bodies.IsMovable(record.BodyA), _bodies.IsMovable(record.BodyB));
            Reach(record.BodyA == woken ? record.BodyB : record.BodyA);
        }
        else
        {
            _contacts.AddIdle(contact);
        }

        _events.Woke(record);
    }

    /// <summary>At the start of a step: what has been set from outside since the last one.</summary>
    public void WakeWhatChanged(float dt)
    {
        _dt = dt;
        bool isTurned = _stores.LastSubstep > 0 && _settings.GravityWakes && _settings.Gravity != _gravityAsleep;
        if (AsleepCount > 0 && (!_settings.AllowSleep || isTurned || IsSleepBarred))
        {
            WakeAll();
        }

        _gravityAsleep = _settings.Gravity;
        for (int i = 0; i < _handled.Count; i++)
        {
            int body = _handled[i];
            ref BodyState state = ref _bodies.State[body];
            _bodies.Flags[body] &= ~BodyFlags.Handled;
            if (_bodies.IsAsleep(body) && (state.LinearVelocity != Vector2.Zero || state.AngularVelocity != 0))
            {
                Wake(body);
            }
        }

        _handled.Clear();
        if (_put.Count > 0)
        {
            WakeBesideAwake();
            LayDownContacts();
        }
    }

    /// <summary>After the bodies are known: what stands on something that has a velocity does not sleep.</summary>
    public void WakeByDriven()
    {
        _bodiesCollected = true;
        for (int i = 0; AsleepCount > 0 && i < _lists.Driven.Count; i++)
        {
            WakeTouching(_lists.Driven[i]);
        }
    }

    /// <summary>
    /// Bodies that were put to sleep one by one do not sleep beside awake ones; nor beside those that this wakes, whose rows are not
    /// dormant yet, so that no flood finds them.
    /// </summary>
    private void WakeBesideAwake()
    {
        // Each round but the last wakes one that sleeps.
        bool more = true;
        for (int rounds = AsleepCount; more && rounds >= 0; rounds--)
        {
            _layDown.Clear();
            FindJointedToAwake();
            FindTouchingAwake();
            for (int i = 0; i < _layDown.Count; i++)
            {
                Wake(_layDown[i]);
            }

            more = _layDown.Count > 0;
        }
    }

    private void FindJointedToAwake()
    {
        for (int i = 0; i < _put.Count; i++)
        {
            for (int entry = _joints.First(_put[i]); _bodies.IsAsleep(_put[i]) && entry >= 0; entry = _joints.Next(entry))
            {
                JointLink link = _joints.Links[entry >> 1];
                if ((_joints.Flags[entry >> 1] & JointFlags.Enabled) != 0 && !(_bodies.IsStill(link.BodyA) && _bodies.IsStill(link.BodyB)))
                {
                    _layDown.Add(_put[i]);
                }
            }
        }
    }

    private unsafe void FindTouchingAwake()
    {
        foreach (GraphColor color in _graph.Used)
        {
            foreach (ContactBundle* row in color.Bundles)
            {
                for (int lane = 0; lane < ContactBundle.Lanes; lane++)
                {
                    int a = row->BodyA[lane];
                    int b = row->BodyB[lane];
                    if (_bodies.IsAsleep(a) != _bodies.IsAsleep(b) && !(_bodies.IsStill(a) && _bodies.IsStill(b)))
                    {
                        _layDown.Add(_bodies.IsAsleep(a) ? a : b);
                    }
                }
            }
        }
    }
}
