using System;
using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace FarseerGames.FarseerPhysics;

/// <content>
/// Joints that come and go. As geoms and bodies they wait for the next update, which takes them in after the bodies.
/// </content>
public partial class PhysicsSimulator
{
    private readonly ItemQueue<Joint> _joints;
    private readonly List<Joint> _jointsDisposed = new List<Joint>();
    private readonly List<(Joint Joint, Body Taken)> _jointsChanged = new List<(Joint Joint, Body Taken)>();
    private readonly JointRelay _jointRelay;
    private bool _jointBodiesChanged;

    /// <summary>The joints in the simulator: a view; see <see cref="Dynamics.Joints.JointList"/>.</summary>
    public JointList JointList { get; }

    /// <summary>
    /// Adds a joint; it acts from the next update on. One that was added before is ignored. Its bodies need not be added: those that are
    /// not are points that nothing moves.
    /// </summary>
    /// <param name="joint">The joint.</param>
    /// <exception cref="ArgumentNullException"><paramref name="joint"/> is null.</exception>
    /// <exception cref="ArgumentException">
    /// The joint or a body of it is in another simulator, or it has no body yet.
    /// </exception>
    /// <exception cref="ObjectDisposedException">The simulator or the joint is disposed.</exception>
    public void Add(Joint joint)
    {
        ThrowIfDisposed();
        if (joint is { IsDisposed: false, Simulator: null })
        {
            CheckBodies(joint);
        }

        if (_joints.Add(joint, nameof(joint)))
        {
            joint!.Link.Hold(this, joint);
        }
    }

    /// <summary>Removes a joint at the next update.</summary>
    /// <param name="joint">The joint; one that is in no simulator is ignored.</param>
    /// <exception cref="ArgumentNullException"><paramref name="joint"/> is null.</exception>
    /// <exception cref="ArgumentException">The joint belongs to another simulator.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    public void Remove(Joint joint)
    {
        ThrowIfDisposed();
        _joints.Remove(joint, nameof(joint));
    }

    internal void NoteDisposed(Joint joint) => _jointsDisposed.Add(joint);

    /// <summary>
    /// A joint was given a body, which is held from now on: another simulator must not get it before this one's next update.
    /// </summary>
    internal void NoteChanged(Joint joint, Body taken)
    {
        HoldBody(taken);
        _jointsChanged.Add((joint, taken));
        _jointBodiesChanged = true;
    }

    internal void HoldBody(Body body)
    {
        body.JointCount++;
        body.Simulator = this;
    }

    internal static void LetGo(Body body)
    {
        body.JointCount--;
        ReleaseIfUnused(body);
    }

    private void TakeIn(Joint joint)
    {
        Attach(joint);
        if (joint.IsUserWritten)
        {
            _jointRelay.Written.Add(joint);
        }

        JointList.TakeIn(joint);
        _jointBodiesChanged = true;
    }

    private void LetGo(Joint joint)
    {
        if (joint.IsUserWritten)
        {
            _jointRelay.Written.Remove(joint);
        }

        Detach(joint);
        joint.Link.LetGo();
        joint.NoteSet();
    }

    private void SweepJoints()
    {
        // The joints of this library ask for disposed bodies only, so without one they need not be asked: a net has thousands.
        List<Joint> asked = _jointBodiesChanged ? JointList : _jointRelay.Written;
        _jointBodiesChanged = false;
        for (int i = 0; i < asked.Count; i++)
        {
            try
            {
                asked[i].Validate();
            }
            catch (Exception exception)
            {
                _relay.Keep(exception);
            }
        }

        _joints.Drop(_jointsDisposed);
        int count = _jointsChanged.Count;
        for (int i = 0; i < count; i++)
        {
            (Joint joint, Body taken) = _jointsChanged[i];
            if (joint.Link.IsAttached && ReferenceEquals(joint.Simulator, this))
            {
                Detach(joint);
                Attach(joint);
            }

            LetGo(taken);
        }

        _jointsChanged.RemoveRange(0, count);
    }

    private void Attach(Joint joint)
    {
        if (!joint.IsSolvedByEngine)
        {
            return;
        }

        joint.Link.Hold(this, joint);
        AttachBody(joint.Link.First);
        AttachBody(joint.Link.Second);
        joint.Link.Attach(World, joint);
        _jointRelay.Set(joint.Link.Index, joint);
        CountJoint(joint.Link.First, 1);
        CountJoint(joint.Link.Second, 1);

        void AttachBody(Body? body)
        {
            if (body is not null)
            {
                this.AttachBody(body);
            }
        }
    }

    private void Detach(Joint joint)
    {
        if (!joint.Link.IsAttached)
        {
            return;
        }

        _jointRelay.Set(joint.Link.Index, null);
        joint.Link.Detach(joint);
        CountJoint(joint.Link.First, -1);
        CountJoint(joint.Link.Second, -1);
    }

    private void CountJoint(Body? body, int change)
    {
        if (body is not null)
        {
            body.Link.Joints += change;
            DetachIfUnused(body);
        }
    }

    private void ClearJoints()
    {
        _joints.Clear();
        _jointsDisposed.Clear();
        foreach ((_, Body taken) in _jointsChanged)
        {
            LetGo(taken);
        }

        _jointsChanged.Clear();
        _jointRelay.Written.Clear();
    }

    private void CheckBodies(Joint joint)
    {
        if (!joint.IsSolvedByEngine)
        {
            return;
        }

        bool needsFirst = joint is PairJoint;
        if (joint.SecondBody is null || (needsFirst && joint.FirstBody is null))
        {
            throw new ArgumentException("The joint has no body yet.", nameof(joint));
        }

        if (!IsMine(joint.FirstBody) || !IsMine(joint.SecondBody))
        {
            throw new ArgumentException("A body of the joint belongs to another simulator.", nameof(joint));
        }
    }

    private bool IsMine(Body? body) => body?.Simulator is null || ReferenceEquals(body.Simulator, this);
}
