using System;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace FarseerGames.FarseerPhysics;

/// <content>
/// Controllers and springs: they act on bodies once per update, controllers first, each kind in the order in which it was added.
/// </content>
public partial class PhysicsSimulator
{
    private readonly ItemQueue<Controller> _controllers;
    private readonly ItemQueue<Spring> _springs;

    /// <summary>The springs in the simulator: a view; see <see cref="Dynamics.Springs.SpringList"/>.</summary>
    public SpringList SpringList { get; }

    /// <summary>
    /// The controllers in the simulator: a view; see <see cref="Controllers.ControllerList"/>. The first is
    /// <see cref="InactivityController"/>.
    /// </summary>
    public ControllerList ControllerList { get; }

    /// <summary>Disables bodies that rest, if it is enabled; off by default.</summary>
    [NotState(Why.Fixed)]
    public InactivityController InactivityController { get; }

    /// <summary>True while forces act: springs then go to the engine.</summary>
    [NotState(Why.Calm)]
    internal bool IsApplyingForces { get; private set; }

    /// <summary>Adds a spring; it acts from the next update on. One that was added before is ignored.</summary>
    /// <param name="spring">The spring.</param>
    /// <exception cref="ArgumentNullException"><paramref name="spring"/> is null.</exception>
    /// <exception cref="ArgumentException">The spring is in another simulator.</exception>
    /// <exception cref="ObjectDisposedException">The simulator or the spring is disposed.</exception>
    public void Add(Spring spring)
    {
        ThrowIfDisposed();
        _springs.Add(spring, nameof(spring));
    }

    /// <summary>Removes a spring at the next update.</summary>
    /// <param name="spring">The spring; one that is in no simulator is ignored.</param>
    /// <exception cref="ArgumentNullException"><paramref name="spring"/> is null.</exception>
    /// <exception cref="ArgumentException">The spring belongs to another simulator.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    public void Remove(Spring spring)
    {
        ThrowIfDisposed();
        _springs.Remove(spring, nameof(spring));
    }

    /// <summary>Adds a controller; it acts from the next update on. One that was added before is ignored.</summary>
    /// <param name="controller">The controller.</param>
    /// <exception cref="ArgumentNullException"><paramref name="controller"/> is null.</exception>
    /// <exception cref="ArgumentException">The controller is in another simulator.</exception>
    /// <exception cref="ObjectDisposedException">The simulator or the controller is disposed.</exception>
    public void Add(Controller controller)
    {
        ThrowIfDisposed();
        _controllers.Add(controller, nameof(controller));
    }

    /// <summary>Removes a controller at the next update.</summary>
    /// <param name="controller">The controller; one that is in no simulator is ignored.</param>
    /// <exception cref="ArgumentNullException"><paramref name="controller"/> is null.</exception>
    /// <exception cref="ArgumentException">The controller belongs to another simulator.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    public void Remove(Controller controller)
    {
        ThrowIfDisposed();
        _controllers.Remove(controller, nameof(controller));
    }

    private static void LetGo(Spring spring) => spring.Memory.LetGo();

    private void TakeInControls()
    {
        _controllers.TakeIn();
        _springs.TakeIn();
    }

    private void TakeOutControls()
    {
        _controllers.TakeOut();
        _springs.TakeOut();
        _springs.Sweep(_relay);
        _controllers.Sweep(_relay);
    }

    private void ClearControls()
    {
        _controllers.Clear();
        _springs.Clear();
        if (!InactivityController.IsDisposed)
        {
            _controllers.Add(InactivityController, nameof(InactivityController));
        }
    }

    private void UpdateControls(float dt)
    {
        IsApplyingForces = true;
        for (int i = 0; i < ControllerList.Count; i++)
        {
            Controller controller = ControllerList[i];
            if (controller.Enabled && !controller.IsDisposed)
            {
                try
                {
                    controller.Update(dt);
                }
                catch (Exception exception)
                {
                    _relay.Keep(exception);
                }
            }
        }

        for (int i = 0; i < SpringList.Count; i++)
        {
            Spring spring = SpringList[i];
            if (spring.Enabled && !spring.IsDisposed)
            {
                try
                {
                    spring.Update(dt);
                }
                catch (Exception exception)
                {
                    _relay.Keep(exception);
                }
            }
        }

        IsApplyingForces = false;
    }
}
