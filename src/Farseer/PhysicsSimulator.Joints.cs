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
    private readonly List<Joint> _jointsIn = new List<Joint>();
    private readonly List<Joint> _jointsOut = new List<Joint>();
    private readonly List<Joint> _jointsDisposed = new List<Joint>();
    private readonly List<Joint> _jointsChanged = new List<Joint>();
    private readonly JointRelay _jointRelay;

    /// <summary>The joints in the simulator: a view; see <see cref="Dynamics.Joints.JointList"/>.</summary>
    public JointList JointList { get; }

    /// <summary>
    /// Adds a joint; it acts from the next update on. Its bodies need not be added: those that are not are points that nothing moves.
    /// </summary>
    /// <param name="joint">The joint.</param>
    /// <exception cref="ArgumentNullException"><paramref name="joint"/> is null.</exception>
    /// <exception cref="ArgumentException">
    /// The joint is in this or another simulator already, a body of it is in another one, or it has no body yet.
    /// </exception>
    /// <exception cref="ObjectDisposedException">The simulator or the joint is disposed.</exception>
    public void Add(Joint joint)
    {
        ThrowIfDisposed();
        Require.NotNull(joint, nameof(joint));
        if (joint.IsDisposed)
        {
            throw new ObjectDisposedException(joint.GetType().Name);
        }

        if (joint.Simulator is not null && !ReferenceEquals(joint.Simulator, this))
        {
            throw new ArgumentException("The joint belongs to another simulator.", nameof(joint));
        }

        switch (joint.Membership)
        {
            case Membership.RemoveQueued:
                joint.Membership = Membership.Added;
                return;
            case Membership.None:
                CheckBodies(joint);
                joint.Membership = Membership.AddQueued;
                joint.Simulator = this;
                joint.Link.Hold(this, joint);
                _jointsIn.Add(joint);
                return;
            default:
                throw new ArgumentException("The joint was added to this simulator before.", nameof(joint));
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
        Require.NotNull(joint, nameof(joint));
        if (joint.Simulator is not null && !ReferenceEquals(joint.Simulator, this))
        {
            throw new ArgumentException("The joint belongs to another simulator.", nameof(joint));
        }

        if (joint.Membership == Membership.AddQueued)
        {
            Forget(joint);
        }
        else if (joint.Membership == Membership.Added)
        {
            joint.Membership = Membership.RemoveQueued;
            _jointsOut.Add(joint);
        }
    }

    internal void NoteDisposed(Joint joint) => _jointsDisposed.Add(joint);

    internal void NoteChanged(Joint joint) => _jointsChanged.Add(joint);

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

    private void TakeJointsIn()
    {
        int count = _jointsIn.Count;
        for (int i = 0; i < count; i++)
        {
            Joint joint = _jointsIn[i];
            if (joint.Membership != Membership.AddQueued || !ReferenceEquals(joint.Simulator, this))
            {
                continue;
            }

            if (joint.IsDisposed)
            {
                Forget(joint);
                continue;
            }

            joint.Membership = Membership.Added;
            Attach(joint);
            if (joint.IsUserWritten)
            {
                _jointRelay.Written.Add(joint);
            }

            JointList.TakeIn(joint);
        }

        _jointsIn.RemoveRange(0, count);
    }

    private void TakeJointsOut()
    {
        int count = _jointsOut.Count;
        for (int i = 0; i < count; i++)
        {
            if (_jointsOut[i].Membership == Membership.RemoveQueued)
            {
                TakeOut(_jointsOut[i]);
            }
        }

        _jointsOut.RemoveRange(0, count);
    }

    private void SweepJoints()
    {
        for (int i = 0; i < JointList.Count; i++)
        {
            try
            {
                JointList[i].Validate();
            }
            catch (Exception exception)
            {
                _relay.Keep(exception);
            }
        }

        int count = _jointsDisposed.Count;
        for (int i = 0; i < count; i++)
        {
            Joint joint = _jointsDisposed[i];
            if (joint.Membership == Membership.AddQueued)
            {
                Forget(joint);
            }
            else if (joint.Membership != Membership.None)
            {
                TakeOut(joint);
            }
        }

        _jointsDisposed.RemoveRange(0, count);
        count = _jointsChanged.Count;
        for (int i = 0; i < count; i++)
        {
            Joint joint = _jointsChanged[i];
            if (joint.Link.IsAttached && ReferenceEquals(joint.Simulator, this))
            {
                Detach(joint);
                Attach(joint);
            }
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

    private void TakeOut(Joint joint)
    {
        Detach(joint);
        Forget(joint);
        _jointRelay.Written.Remove(joint);
        JointList.TakeOut(joint);
    }

    private static void Forget(Joint joint)
    {
        joint.Membership = Membership.None;
        joint.Link.LetGo();
        joint.Simulator = null;
    }

    private void ClearJoints()
    {
        for (int i = 0; i < _jointsIn.Count; i++)
        {
            if (_jointsIn[i].Membership == Membership.AddQueued && ReferenceEquals(_jointsIn[i].Simulator, this))
            {
                Forget(_jointsIn[i]);
            }
        }

        for (int i = 0; i < JointList.Count; i++)
        {
            Detach(JointList[i]);
            Forget(JointList[i]);
        }

        JointList.Clear();
        _jointsIn.Clear();
        _jointsOut.Clear();
        _jointsDisposed.Clear();
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
